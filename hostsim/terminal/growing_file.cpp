#include <halftone/terminal/growing_file.h>

#include <halftone/file/write.h>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace halftone::terminal {

GrowingFile::GrowingFile(const std::filesystem::path& file) : file_(file) {
  file::check_writable(file);
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw file::WriteError(file.string() + ": cannot be written: " + std::strerror(errno));
}

GrowingFile::~GrowingFile() { ::close(descriptor_); }

void GrowingFile::append(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    else if (count < 0 && errno != EINTR)
      throw file::WriteError(file_.string() + ": cannot be written: " + std::strerror(errno));
  }
}

} // namespace halftone::terminal
