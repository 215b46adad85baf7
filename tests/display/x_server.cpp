#include "x_server.h"

#include "support/comes_true.h"
#include "support/scratch.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace halftone::test {

namespace {

using Clock = std::chrono::steady_clock;

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

} // namespace

Running::Running(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 const std::vector<std::string>& environment) {
  std::vector<std::string> arguments = words, variables = environment;
  // What SDL2's libraries do not give back at the end is none of ours, and AddressSanitizer cannot tell.
  variables.emplace_back("ASAN_OPTIONS=detect_leaks=0");
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, 1, (folder / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
  ::posix_spawn_file_actions_addopen(&actions, 2, (folder / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                     0600);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  const int error = ::posix_spawnp(&process_, words[0].c_str(), &actions, nullptr, pointers(arguments).data(),
                                   pointers(variables).data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), words[0]);
}

Running::~Running() {
  if (process_ == 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Running::send(int signal) const {
  if (process_ != 0) ::kill(process_, signal);
}

int Running::wait(std::chrono::milliseconds patience) {
  const auto end = Clock::now() + patience;
  int status = 0;
  while (::waitpid(process_, &status, WNOHANG) == 0) {
    if (Clock::now() > end) return -1;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  process_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string printed(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen((command + " 2>/dev/null").c_str(), "r"),
                                                             ::pclose);
  std::string text;
  std::array<char, 4096> buffer;
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe.get())) != 0;)
    text.append(buffer.data(), count);
  return text;
}

std::string missing(const std::vector<std::string>& programs) {
  std::string names;
  for (const std::string& program : programs)
    if (printed("command -v " + program).empty()) names += ' ' + program;
  return names;
}

// -noreset: a server begins anew when its last client has gone, which may be an xdotool, and drops who comes
// in that moment.
XServer::XServer(const std::filesystem::path& folder)
    : folder_(folder / "x"),
      server_((std::filesystem::create_directory(folder_),
               std::vector<std::string>{"Xvfb", "-displayfd", "1", "-screen", "0", "1280x1100x24",
                                        "-nolisten", "tcp", "-noreset"}),
              folder_) {
  if (!comes_true([&] { return contents(folder_ / "out").find('\n') != std::string::npos; }))
    throw std::runtime_error("Xvfb has not started");
  const std::string number = contents(folder_ / "out");
  display_ = ':' + number.substr(0, number.find('\n'));
}

void XServer::kill() const { server_.send(SIGKILL); }

std::string XServer::window_of(const Running& process) const {
  std::string window;
  comes_true([&] {
    window = printed(environment() + " timeout 10 xdotool search --onlyvisible --pid " +
                     std::to_string(process.number()));
    return !window.empty();
  });
  return window.substr(0, window.find('\n'));
}

std::string XServer::title_of(const std::string& window) const {
  const std::string line = printed(environment() + " timeout 10 xdotool getwindowname " + window);
  return line.substr(0, line.find('\n'));
}

void XServer::act(const std::string& what) const { printed(environment() + " timeout 10 xdotool " + what); }

png::Picture XServer::picture_of(const std::string& window) const {
  const std::string file = (folder_ / "picture.png").string();
  std::filesystem::remove(file);
  // On a busy machine `import` has waited for an answer of the server that never came.
  for (int attempt = 0; attempt < 3 && !std::filesystem::exists(file); ++attempt)
    printed(environment() + " timeout 10 import -window " + window + " -depth 8 PNG24:'" + file + '\'');
  return std::filesystem::exists(file) ? png::read(file) : png::Picture{};
}

} // namespace halftone::test
