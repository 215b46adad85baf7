#pragma once
// A program that runs for as long as this one has use for it.

#include <halftone/file/descriptor.h>

#include <string>
#include <vector>

#include <sys/types.h>

namespace halftone::display {

/// Does not outlive its owner, who ends it, nor the thread that started it, where that is killed.
class Child {
public:
  /// Starts the first of the words, which is looked for on PATH, with a descriptor as its standard input.
  /// Throws std::system_error where it cannot be started.
  Child(std::vector<std::string> words, const file::Descriptor& input);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Does not wait. Whoever owns a child asks often: it waits to be read from.
  bool is_running();

  /// The last line that it wrote to its standard error.
  const std::string& last_words() const { return last_words_; }

private:
  void read_words();

  pid_t process_ = 0; ///< 0: has ended
  file::Descriptor errors_;
  std::string last_words_;
  std::string unfinished_; ///< the line after it
};

} // namespace halftone::display
