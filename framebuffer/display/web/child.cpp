#include "child.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>

namespace halftone::display {

namespace {

using namespace std::chrono_literals;

constexpr auto patience = 2s;
constexpr std::size_t longest_line = 300;

/// The child's side, where nothing may be called that could wait for a thread that is not there: no memory,
/// no output.
[[noreturn]] void become(char* const* words, int input, int errors, int failure, pid_t parent) {
  // Not ended by Ctrl-C, which reaches all of a terminal's processes, but by its owner.
  ::setpgid(0, 0);
  // Of the signals the one that no program can miss: an exception that websockify's handler of SIGTERM throws
  // is lost where Python happens to be in a destructor.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0); // it was killed before that was said
  // What the program has blocked and ignored is its own affair.
  sigset_t none;
  ::sigemptyset(&none);
  ::pthread_sigmask(SIG_SETMASK, &none, nullptr);
  ::signal(SIGPIPE, SIG_DFL);
  ::dup2(input, STDIN_FILENO);
  ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execvp(words[0], words);
  const int error = errno;
  [[maybe_unused]] const auto written = ::write(failure, &error, sizeof error);
  ::_exit(1);
}

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
    reader = file::Descriptor(ends[0]);
    writer = file::Descriptor(ends[1]);
  }
  file::Descriptor reader;
  file::Descriptor writer;
};

} // namespace

Child::Child(std::vector<std::string> words, const file::Descriptor& input) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  Pipe errors, failure;
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ == 0)
    become(pointers.data(), input.number(), errors.writer.number(), failure.writer.number(), parent);
  failure.writer = file::Descriptor();
  int error = 0;
  // The end of the file once it is the program: that end of the pipe is closed by execvp.
  if (::read(failure.reader.number(), &error, sizeof error) == sizeof error) {
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
    throw std::system_error(error, std::generic_category(), words[0]);
  }
  errors_ = std::move(errors.reader);
  ::fcntl(errors_.number(), F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  if (process_ == 0) return;
  const pid_t group = process_;
  ::kill(process_, SIGTERM);
  const auto end = std::chrono::steady_clock::now() + patience;
  while (is_running() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(5ms);
  const bool stays = process_ != 0;
  ::kill(-group, SIGKILL); // with what it has started for those who look
  if (stays) ::waitpid(group, nullptr, 0);
}

bool Child::is_running() {
  read_words();
  if (process_ != 0 && ::waitpid(process_, nullptr, WNOHANG) == process_) {
    process_ = 0;
    read_words();
  }
  return process_ != 0;
}

void Child::read_words() {
  std::array<char, 4096> buffer;
  for (ssize_t count = 0; (count = ::read(errors_.number(), buffer.data(), buffer.size())) > 0;) {
    unfinished_.append(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = unfinished_.find('\n')) != std::string::npos;
         unfinished_.erase(0, end + 1))
      if (end > 0) last_words_ = unfinished_.substr(0, std::min(end, longest_line));
    if (unfinished_.size() > longest_line) unfinished_.resize(longest_line);
  }
}

} // namespace halftone::display
