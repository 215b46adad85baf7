#include <halftone/terminal/growing_file.h>

#include <halftone/file/write.h>

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace halftone::terminal {

GrowingFile::GrowingFile(const std::filesystem::path& file) : file_(file) {
  file::check_writable(file);
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(errno);
}

GrowingFile::~GrowingFile() { ::close(descriptor_); }

void GrowingFile::append(std::span<const std::uint8_t> bytes) {
  auto rest = bytes;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count > 0) {
      rest = rest.subspan(static_cast<std::size_t>(count));
    } else if (count < 0 && errno != EINTR) {
      const int error = errno;
      // Where even that fails, the file ends in the midst of the bytes, as after a crash.
      static_cast<void>(::ftruncate(descriptor_, whole_));
      fail(error);
    }
  }
  whole_ += static_cast<off_t>(bytes.size());
}

void GrowingFile::fail(int error) const {
  throw file::WriteError(file_.string() + ": cannot be written: " + std::strerror(error));
}

} // namespace halftone::terminal
