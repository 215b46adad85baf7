#pragma once
// A folder of a test's own.

#include <filesystem>
#include <string>
#include <vector>

namespace halftone::test {

/// A new, empty folder that vanishes with everything in it.
class Scratch {
public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::filesystem::path path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& text) const;

  /// The names of all that is in it, sorted.
  std::vector<std::string> names() const;

private:
  std::filesystem::path path_;
};

/// The bytes of a file; "(no such file)" where it is not there.
std::string contents(const std::filesystem::path& file);

} // namespace halftone::test
