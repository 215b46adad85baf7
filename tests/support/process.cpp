#include "process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace halftone::test {

namespace {

int checked(int result, const char* what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
  return result;
}

class Descriptor {
public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

private:
  int number_;
};

/// What the process writes into, and where we read it.
struct Channel {
  Descriptor ours;
  Descriptor theirs;
};

Channel open_pipe() {
  std::array<int, 2> ends{};
  checked(::pipe2(ends.data(), O_CLOEXEC), "pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Channel open_terminal() {
  Descriptor ours(checked(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC), "posix_openpt"));
  checked(::grantpt(ours.number()), "grantpt");
  checked(::unlockpt(ours.number()), "unlockpt");
  const char* name = ::ptsname(ours.number());
  if (name == nullptr) throw std::system_error(errno, std::generic_category(), "ptsname");
  Descriptor theirs(checked(::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC), name));
  return {std::move(ours), std::move(theirs)};
}

/// Reads what is there; false at the end (which a terminal reports as EIO).
bool read_some(const Descriptor& from, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

pid_t start(const std::vector<std::string>& arguments, const Surroundings& surroundings, int out, int err) {
  std::vector<std::string> words{HALFTONE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = surroundings.environment;
  for (char** variable = environ; *variable != nullptr; ++variable) environment.emplace_back(*variable);

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, out, 1);
  ::posix_spawn_file_actions_adddup2(&actions, err, 2);
  ::posix_spawn_file_actions_addchdir_np(&actions, surroundings.folder.c_str());
  pid_t process = 0;
  const int error = ::posix_spawn(&process, HALFTONE_PROGRAM, &actions, nullptr, pointers(words).data(),
                                  pointers(environment).data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), HALFTONE_PROGRAM);
  return process;
}

} // namespace

Outcome run_halftone(const std::vector<std::string>& arguments, const Surroundings& surroundings) {
  Channel out = open_pipe();
  if (!surroundings.out_file.empty())
    out.theirs = Descriptor(checked(::open(surroundings.out_file.c_str(), O_WRONLY | O_CLOEXEC), "out_file"));
  Channel err = surroundings.terminal ? open_terminal() : open_pipe();
  const pid_t process = start(arguments, surroundings, out.theirs.number(), err.theirs.number());
  out.theirs = Descriptor();
  err.theirs = Descriptor();

  Outcome outcome;
  std::array<pollfd, 2> open{{{out.ours.number(), POLLIN, 0}, {err.ours.number(), POLLIN, 0}}};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left.count() <= 0 || ::poll(open.data(), open.size(), static_cast<int>(left.count())) == 0) {
      ::kill(process, SIGKILL);
      break;
    }
    if (open[0].revents != 0 && !read_some(out.ours, outcome.out)) open[0].fd = -1;
    if (open[1].revents != 0) {
      if (!read_some(err.ours, outcome.err)) open[1].fd = -1;
      const int signal = surroundings.on_stderr ? surroundings.on_stderr(outcome.err) : 0;
      if (signal != 0 && open[1].fd >= 0) ::kill(process, signal);
    }
  }

  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  return outcome;
}

bool has_terminals() {
  try {
    open_terminal();
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

} // namespace halftone::test
