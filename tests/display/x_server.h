#pragma once
// An X server without a monitor, and what people do at one: the driver that the window has there is that of a
// desktop.

#include <halftone/png/png.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace halftone::test {

/// A process that ends with the test.
class Running {
public:
  /// Throws std::system_error where it cannot be started. Its output goes to files out and err in the folder.
  Running(const std::vector<std::string>& words, const std::filesystem::path& folder,
          const std::vector<std::string>& environment = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  pid_t number() const { return process_; }
  void send(int signal) const;

  /// Its exit code; -1 where it has not ended by itself within this time.
  int wait(std::chrono::milliseconds patience = std::chrono::seconds(30));

private:
  pid_t process_ = 0; ///< 0: has ended
};

/// What a command of the shell prints; empty where it fails.
std::string printed(const std::string& command);

/// Names of the programs of these that are not installed, as in " xdotool import"; empty if all are.
std::string missing(const std::vector<std::string>& programs);

/// Xvfb on a display number that it finds free, 1280 x 1100 with 24 bits.
class XServer {
public:
  explicit XServer(const std::filesystem::path& folder);

  /// The server goes, whoever still looks.
  void kill() const;

  /// As in "DISPLAY=:7".
  std::string environment() const { return "DISPLAY=" + display_; }

  /// The window of a process, in decimal; empty if it does not come.
  std::string window_of(const Running& process) const;

  std::string title_of(const std::string& window) const;

  /// What xdotool is to do, as in "key plus".
  void act(const std::string& what) const;

  /// What the window shows.
  png::Picture picture_of(const std::string& window) const;

private:
  std::filesystem::path folder_;
  std::string display_;
  Running server_;
};

} // namespace halftone::test
