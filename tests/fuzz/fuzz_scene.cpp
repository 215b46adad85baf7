// Any text is read as a scene of finite numbers, or refused at a place inside it; and what was read means a
// world of finite numbers and unit normals.

#include "numbers.h"
#include "small_scene.h"

#include <halftone/core/error.h>
#include <halftone/scene/read.h>
#include <halftone/scene/world.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

using namespace halftone;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

/// As docs/scene-format.md promises: one line that says where, what and what to do.
void check(const core::InputError& error, std::string_view text) {
  const std::string_view message = error.what();
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  require(error.place.file == "fuzz.toml" && error.place.line >= 1 && error.place.line <= lines + 1 &&
          error.place.column >= 1);
  require(message.find_first_of("\n\r") == std::string_view::npos);
  const std::size_t advice = message.rfind("; ");
  require(message.starts_with("fuzz.toml:") && advice != std::string_view::npos &&
          advice + 2 < message.size());
}

void check(const scene::World& world) {
  fuzz::Numbers finite;
  finite(world.extent);
  for (const scene::Surface& surface : world.surfaces) finite(surface);
  for (const scene::Body& body : world.bodies) {
    for (const core::Vec3& corner : body.bounds) finite(corner);
    for (const scene::Face& face : body.faces) {
      require(face.surface >= 0 && static_cast<std::size_t>(face.surface) < world.surfaces.size());
      for (const core::Vec3& corner : face.outline) finite(corner);
      for (const auto& edge : face.pattern_edge) finite(edge.value_or(0));
    }
  }
  for (const core::Vec3& vector : {world.camera.forward, world.camera.right, world.camera.up}) finite(vector);
  finite(world.camera.direction(0, 0));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  scene::Scene scene;
  try {
    scene = scene::read_toml(text, "fuzz.toml");
  } catch (const core::InputError& error) {
    check(error, text);
    return 0;
  }
  fuzz::Numbers finite;
  finite(scene);
  fuzz::make_small(scene);
  check(make_world(scene));
  check(make_world(scanline_scene(scene)));
  return 0;
}
