#include <halftone/terminal/output_file.h>

#include <halftone/terminal/exit_code.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace halftone::terminal {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw OutputError(file.string() + ": cannot be written: " + why);
}

/// Writes everything to the descriptor; 0, or the errno of the failure.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
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
  if (beside.descriptor < 0) fail(file, std::strerror(errno));
  return beside;
}

/// Where a file is or would be, whatever it is called: absolute, without links.
fs::path place_of(const fs::path& file) {
  std::error_code none; // as at the end of a loop of links, where writing will fail
  return fs::weakly_canonical(fs::absolute(file, none), none);
}

bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code none;
  if (fs::equivalent(a, b, none)) return true;
  const fs::path place = place_of(a);
  return !place.empty() && place == place_of(b);
}

} // namespace

void check_writable(const fs::path& file) {
  if (file.filename().empty()) fail(file, "expected the name of a file");
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) fail(file, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(file, "it is not a regular file");

  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (!fs::exists(folder, error)) fail(file, "the folder " + folder.string() + " does not exist");
  if (!fs::is_directory(folder, error)) fail(file, folder.string() + " is not a folder");
  // Permissions do not tell everything: some file systems take no new files from anyone.
  const NewFile trial = create_beside(file);
  ::close(trial.descriptor);
  ::unlink(trial.path.c_str());
}

void check_outputs(const std::vector<Output>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->file.empty()) continue;
    const std::string named = output->option + ' ' + output->file.string() + ": ";
    for (const fs::path& input : inputs)
      if (!input.empty() && are_same(output->file, input))
        throw ArgumentError(named + "is an input, which would be lost");
    for (auto other = outputs.begin(); other != output; ++other)
      if (!other->file.empty() && are_same(output->file, other->file))
        throw ArgumentError(named + "is what " + other->option + " writes, which would be lost");
    check_writable(output->file);
  }
}

void write_whole(const fs::path& file, std::string_view bytes) {
  const auto [beside, descriptor] = create_beside(file);
  int failure = write_all(descriptor, bytes);
  if (::close(descriptor) != 0 && failure == 0) failure = errno;
  if (failure == 0 && ::rename(beside.c_str(), file.c_str()) != 0) failure = errno;
  if (failure != 0) {
    ::unlink(beside.c_str());
    fail(file, std::strerror(failure));
  }
}

SignalShelter::SignalShelter() {
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  ::sigaction(SIGINT, &ignore, &interrupt_);
  ::sigaction(SIGTERM, &ignore, &terminate_);
  ::sigaction(SIGHUP, &ignore, &hang_up_);
}

SignalShelter::~SignalShelter() {
  ::sigaction(SIGINT, &interrupt_, nullptr);
  ::sigaction(SIGTERM, &terminate_, nullptr);
  ::sigaction(SIGHUP, &hang_up_, nullptr);
}

} // namespace halftone::terminal
