#include <halftone/file/write.h>

#include <cerrno>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace halftone::file {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw WriteError(file.string() + ": cannot be written: " + why);
}

[[noreturn]] void fail(const fs::path& file, int error) {
  fail(file, std::generic_category().message(error));
}

/// Writes everything to the descriptor; 0, or the errno of the failure.
int write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return 0;
}

struct NewFile {
  fs::path path;
  int descriptor = -1;
};

NewFile create_beside(const fs::path& file) {
  std::random_device random;
  NewFile beside;
  do { // another program may be writing the same file under the same name
    beside.path = file.string() + "." + std::to_string(random()) + ".tmp";
    beside.descriptor = ::open(beside.path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (beside.descriptor < 0 && errno == EEXIST);
  if (beside.descriptor < 0) fail(file, errno);
  return beside;
}

/// A device or a pipe would be replaced by a file; and nobody can tell what a link to nothing is the same as.
void refuse_what_is_no_file(const fs::path& file) {
  if (file.filename().empty()) fail(file, "expected the name of a file");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) fail(file, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(file, "it is not a regular file");
  if (!fs::exists(status) && fs::is_symlink(fs::symlink_status(file, error)))
    fail(file, "it is a link to nothing");
}

} // namespace

void check_writable(const fs::path& file) {
  refuse_what_is_no_file(file);
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::exists(folder, error)) fail(file, "the folder " + folder.string() + " does not exist");
  if (!fs::is_directory(folder, error)) fail(file, folder.string() + " is not a folder");
  // Permissions do not tell everything: some file systems take no new files from anyone.
  const NewFile trial = create_beside(file);
  ::close(trial.descriptor);
  ::unlink(trial.path.c_str());
}

void write_whole(const fs::path& file, std::span<const std::byte> bytes) {
  refuse_what_is_no_file(file);
  const NewFile beside = create_beside(file);
  int failure = write_all(beside.descriptor, bytes);
  if (::close(beside.descriptor) != 0 && failure == 0) failure = errno;
  if (failure == 0 && ::rename(beside.path.c_str(), file.c_str()) != 0) failure = errno;
  if (failure != 0) {
    ::unlink(beside.path.c_str());
    fail(file, failure);
  }
}

} // namespace halftone::file
