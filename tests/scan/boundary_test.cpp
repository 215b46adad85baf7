#include <halftone/reference/reference.h>
#include <halftone/scan/scanner.h>
#include <halftone/scene/read.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

// What a single virtual scanline holds, against the reference along the very same line: boundaries are where
// they are, not where samples happen to fall.

using namespace halftone;

namespace {

/// Straight down on the plane z = 0; a pixel is about 0.14 wide there.
const std::string above = R"(
format = 1
[image]
width = 64
height = 8
[camera]
eye = [0.0137, 0.02, 14]
target = [0.0137, 0.02, 0]
up = [0, 1, 0]
fov = 4.6
[background]
color = [0.1, 0.2, 0.9]
[ambient]
color = [0.5, 0.5, 0.5]
)";

const std::string far_light = "[[light]]\nposition = [0.3e6, 0, 1e6]\ncolor = [0.5, 0.5, 0.5]\n";

const std::string checkered_floor = R"(
[material.checkered]
diffuse = [1, 1, 1]
checker = { color = [0, 0, 0], size = 0.27, axes = "xy" }
[[object]]
shape = "polygon"
material = "checkered"
vertices = [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]
)";

const std::string plain_floor = R"(
[[object]]
shape = "polygon"
vertices = [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]
)";

const std::string black = "[material.black]\ndiffuse = [0, 0, 0]\n";

const std::string glass_pane = R"(
[material.glass]
ior = 1.5
[[object]]
shape = "box"
material = "glass"
min = [-9, -9, 20]
max = [9, 9, 21]
)";

/// The largest difference of a channel, over a row of pixels scanned with so many lines, from the mean of 512
/// rays a pixel along each of the same lines.
double largest_error(const std::string& text, int lines) {
  const scene::World world = scene::make_world(scene::read_toml(text, "test.toml"));
  const scan::Frame frame(world);
  scan::Scanner scanner(frame);
  const reference::Reference reference(world);
  reference::Counts counts;
  constexpr int y = 3, rays = 512;
  const scan::Row row = scanner.scan(y, lines);
  double largest = 0;
  for (int x = 0; x < world.camera.width; ++x) {
    core::Color mean{0};
    for (int line = 0; line < lines; ++line)
      for (int i = 0; i < rays; ++i)
        mean += reference.radiance(x + (i + 0.5) / rays, y + (line + 0.5) / lines, counts);
    mean /= static_cast<double>(rays * lines);
    largest = std::max(largest, core::max_component(glm::abs(row.radiance[x] - mean)));
  }
  return largest;
}

constexpr double one_ray = 1.0 / 512; ///< by which an edge between black and white can be off in the mean

} // namespace

TEST_CASE("lines of a pattern are exact on a virtual scanline") {
  CHECK(largest_error(above + checkered_floor, 1) < 2 * one_ray);
  CHECK(largest_error(above + far_light + checkered_floor, 1) < 2 * one_ray);
}

TEST_CASE("lines of a pattern are found to 1/128 of a pixel where lights need tests") {
  CHECK(largest_error(above + far_light + checkered_floor + glass_pane, 1) < 2 * (one_ray + 0x1p-8));
}

TEST_CASE("the outline of a traced body is found to 1/128 of a pixel, whatever the number of lines") {
  const std::string sphere = black + R"(
[[object]]
shape = "sphere"
material = "black"
trace = "always"
center = [0.2, 0.02, 1]
radius = 0.411
)";
  for (const int lines : {1, 2, 5}) {
    INFO(lines << " lines");
    CHECK(largest_error(above + plain_floor + sphere, lines) < 2 * (one_ray + 0x1p-8));
  }
}

TEST_CASE("with sixteen lines nothing that is wider than an eighth of a pixel is missed") {
  const std::string thread = black + R"(
[[object]]
shape = "cylinder"
material = "black"
trace = "always"
base = [-0.6, -2, 1]
top = [-0.53, 2, 1]
radius = 0.0093
)"; // a seventh of a pixel wide
  CHECK(largest_error(above + plain_floor + thread, 16) < 2 * (one_ray + 0x1p-8));
}

TEST_CASE("the shadow of a cylinder is found to 1/128 of a pixel") {
  const std::string cylinder = R"(
[[object]]
shape = "cylinder"
base = [-0.3, -9, 20]
top = [0.5, 9, 20]
radius = 0.2
)";
  CHECK(largest_error(above + far_light + plain_floor + cylinder, 1) < 2 * (one_ray + 0x1p-8));
}

TEST_CASE("smooth light under glass is integrated to the second order") {
  const std::string near_light = "[[light]]\nposition = [-0.6, 0, 2]\ncolor = [0.5, 0.5, 0.5]\n";
  const std::string low_pane = R"(
[material.glass]
ior = 1.5
[[object]]
shape = "box"
material = "glass"
min = [-9, -9, 0.3]
max = [9, 9, 0.4]
)";
  // Steeper than the angle at which the pane reflects all of it. Seen from below the pane, so that only the
  // light passes it.
  std::string below = above;
  below.replace(below.find("0.02, 14]"), 9, "0.02, 0.2]");
  below.replace(below.find("fov = 4.6"), 9, "fov = 40");
  CHECK(largest_error(below + near_light + plain_floor + low_pane, 1) < 1e-4);
}
