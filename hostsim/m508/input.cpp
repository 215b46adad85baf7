#include "input.h"

#include <halftone/bus/buses.h>
#include <halftone/core/error.h>
#include <halftone/file/descriptor.h>
#include <halftone/recording/read.h>
#include <halftone/terminal/exit_code.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace halftone::m508 {

namespace {

[[noreturn]] void fail(const std::string& file, int error) {
  throw core::InputError({file}, std::generic_category().message(error));
}

} // namespace

std::string read_text(const std::string& file) {
  const bool standard = file == "-";
  const file::Descriptor opened(standard ? -1 : ::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  const int source = standard ? STDIN_FILENO : opened.number();
  struct stat status {};
  if (source < 0 || ::fstat(source, &status) != 0) fail(file, errno);
  if (S_ISDIR(status.st_mode)) throw core::InputError({file}, "is a folder");
  const bool is_bounded = !S_ISREG(status.st_mode);

  std::string text;
  std::array<char, 1 << 16> buffer;
  while (true) {
    const ssize_t count = ::read(source, buffer.data(), buffer.size());
    if (count == 0) return text;
    if (count < 0 && errno != EINTR) fail(file, errno);
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    if (is_bounded && text.size() > stream_limit)
      throw core::InputError({file}, "is no regular file, and has more than " +
                                         std::to_string(stream_limit >> 20) +
                                         " MB; if it has an end, save it to a file first");
  }
}

recording::Trace read_trace(const std::string& file) {
  const std::string bytes = read_text(file);
  const std::span<const char> chars = bytes;
  recording::Trace trace =
      recording::read({reinterpret_cast<const std::uint8_t*>(chars.data()), chars.size()}, file);
  if (!trace.cut_off.empty())
    std::cerr << "m508: " << file << ": the last record is cut off after " << trace.cut_off.size()
              << " bytes, and left out\n";
  return trace;
}

std::vector<device::Bus> read_buses(const std::string& file) {
  return file.empty() ? bus::built_in() : bus::parse_buses(read_text(file), file);
}

std::filesystem::path path_of(const std::string& input) {
  std::error_code none;
  return std::filesystem::canonical(input == "-" ? "/dev/stdin" : input, none);
}

void check_files(const std::vector<terminal::Output>& outputs, const std::vector<std::string>& inputs) {
  if (std::ranges::count(inputs, "-") > 1)
    throw terminal::ArgumentError(
        "standard input can be read once; save one of the inputs called - to a file");
  std::vector<std::filesystem::path> files;
  for (const std::string& input : inputs) files.push_back(path_of(input));
  terminal::check_outputs(outputs, files);
}

} // namespace halftone::m508
