#pragma once
// m508 serve as a user starts it.

#include <halftone/file/descriptor.h>

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace halftone::test {

class ServerProcess {
public:
  /// Starts m508 serve with these arguments and waits until it says where it listens, or ends. Throws
  /// std::system_error where it cannot be started. Without anybody that listens its stdout is a pipe that
  /// nobody reads.
  explicit ServerProcess(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".",
                         bool somebody_listens = true);

  /// Ends it, whatever it does.
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  /// As in "listening on ADDRESS"; empty if it did not come to that.
  const std::string& address() const { return address_; }

  void send(int signal) const;

  /// Waits for its end, not longer than ten seconds; its exit code, -1 where it did not end by itself.
  int wait();

  /// What it said on stderr, complete after wait.
  const std::string& errors() const { return errors_; }

  /// Memory that it has taken so far, in bytes.
  std::size_t peak_memory() const;

private:
  void read_errors();

  pid_t process_ = 0; ///< 0: has ended
  file::Descriptor out_;
  file::Descriptor err_;
  std::string address_;
  std::string errors_;
};

} // namespace halftone::test
