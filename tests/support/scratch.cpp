#include "scratch.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>

namespace halftone::test {

namespace fs = std::filesystem;

Scratch::Scratch() {
  std::string pattern =
      (fs::temp_directory_path() / "halftone test XXXXXX").string(); // with blanks, as users have them
  if (::mkdtemp(pattern.data()) == nullptr) throw std::system_error(errno, std::generic_category(), pattern);
  path_ = pattern;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string Scratch::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name) << text;
  return *this / name;
}

std::vector<std::string> Scratch::names() const {
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_))
    result.push_back(entry.path().filename());
  std::sort(result.begin(), result.end());
  return result;
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return "(no such file)";
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace halftone::test
