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

std::string small_scene(int width, int height, const std::string& transfer) {
  return "format = 1\n"
         "title = \"small\"\n"
         "[image]\nwidth = " +
         std::to_string(width) + "\nheight = " + std::to_string(height) + "\ntransfer = \"" + transfer +
         "\"\n"
         R"([camera]
eye = [0, -8, 3]
target = [0, 0, 0.8]
[background]
color = [0.3, 0.4, 0.6]
[ambient]
color = [0.2, 0.2, 0.2]
[[light]]
position = [-4, -5, 8]
color = [0.8, 0.8, 0.7]
[material.floor]
checker = { color = [0.2, 0.3, 0.4] }
[material.glass]
ior = 1.5
[material.mirror]
mirror = [0.6, 0.6, 0.6]
[[object]]
shape = "polygon"
material = "floor"
vertices = [[-6, -6, 0], [6, -6, 0], [6, 6, 0], [-6, 6, 0]]
[[object]]
name = "ball"
shape = "sphere"
material = "glass"
center = [-1, 0, 1]
radius = 1
[[object]]
shape = "box"
material = "mirror"
min = [0.5, 0, 0]
max = [1.5, 1, 1.5]
[[object]]
shape = "cone"
trace = "never"
base = [2.5, 0, 0]
apex = [2.5, 0, 1]
radius = 0.7
)";
}

} // namespace halftone::test
