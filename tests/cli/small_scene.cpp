#include "small_scene.h"

namespace halftone::test {

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
