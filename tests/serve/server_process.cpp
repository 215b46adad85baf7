#include "server_process.h"

#include <halftone/file/descriptor.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace halftone::test {

namespace {

using file::Descriptor;

struct Pipe {
  Descriptor ours;
  Descriptor theirs;
};

Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

std::string read_line(int from) {
  std::string line;
  for (char character = 0; ::read(from, &character, 1) == 1 && character != '\n';) line += character;
  return line;
}

} // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                             bool somebody_listens) {
  std::vector<std::string> words{HALFTONE_M508, "serve"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  Pipe out = open_pipe(), err = open_pipe();
  if (!somebody_listens) out.ours.close();
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, out.theirs.number(), 1);
  ::posix_spawn_file_actions_adddup2(&actions, err.theirs.number(), 2);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  const int error = ::posix_spawn(&process_, HALFTONE_M508, &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), HALFTONE_M508);
  out.theirs.close();
  err.theirs.close();

  const std::string line = read_line(out.ours.number()), start = "listening on ";
  if (line.starts_with(start)) address_ = line.substr(start.size());
  out_ = std::move(out.ours); // to be kept open: the process would notice
  err_ = std::move(err.ours);
}

ServerProcess::~ServerProcess() {
  if (process_ != 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
}

void ServerProcess::send(int signal) const {
  if (process_ != 0) ::kill(process_, signal);
}

int ServerProcess::wait() {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  int status = 0;
  while (::waitpid(process_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) return -1;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  process_ = 0;
  read_errors();
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void ServerProcess::read_errors() {
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = ::read(err_.number(), buffer.data(), buffer.size())) > 0;)
    errors_.append(buffer.data(), static_cast<std::size_t>(count));
}

std::size_t ServerProcess::peak_memory() const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

} // namespace halftone::test
