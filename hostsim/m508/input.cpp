#include "input.h"

#include <halftone/core/error.h>
#include <halftone/recording/read.h>
#include <halftone/terminal/exit_code.h>
#include <halftone/terminal/output_file.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <system_error>

namespace halftone::m508 {

std::string read_text(const std::string& file) {
  const bool standard = file == "-";
  if (std::error_code ignored; !standard && std::filesystem::is_directory(file, ignored))
    throw core::InputError({file}, "is a folder");
  std::ifstream stream;
  if (!standard) stream.open(file, std::ios::binary);
  if (!stream) throw core::InputError({file}, std::generic_category().message(errno));
  std::istream& source = standard ? std::cin : stream;
  std::string text{std::istreambuf_iterator<char>(source), {}};
  if (source.bad()) throw core::InputError({file}, "cannot be read to its end");
  return text;
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

void check_output(const std::string& output, const std::string& input) {
  if (std::error_code ignored; input != "-" && std::filesystem::equivalent(output, input, ignored))
    throw terminal::ArgumentError("-o " + output + ": is the input, which would be lost");
  terminal::check_writable(output);
}

} // namespace halftone::m508
