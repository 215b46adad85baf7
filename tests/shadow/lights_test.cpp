#include <halftone/shadow/lights.h>

#include <catch2/catch.hpp>

using namespace halftone;

namespace {

/// An opaque box, a glass box beside it, and a light.
scene::Scene lit_from(const core::Vec3& light) {
  scene::Scene built;
  built.camera = {{0, -8, 3}, {0, 0, 0}, {0, 0, 1}, 40};
  built.materials.resize(2);
  built.materials[1].glass = scene::Glass{};
  built.objects.resize(2);
  built.objects[0].shape = scene::Box{{-2, -1, -1}, {0, 1, 1}};
  built.objects[1].shape = scene::Box{{1, -1, -1}, {3, 1, 1}};
  built.objects[1].material = 1;
  built.lights.push_back({light, core::Color{1}});
  return built;
}

std::size_t reaching(const scene::Scene& scene) {
  return shadow::reaching_lights(scene::make_world(scene)).size();
}

} // namespace

TEST_CASE("a light shut in an opaque solid reaches nothing, unless the eye is in there") {
  scene::Scene shut_in = lit_from({-1, 0.5, 0.5});
  CHECK(reaching(shut_in) == 0);
  shut_in.camera.eye = {-1, -0.5, 0};
  CHECK(reaching(shut_in) == 1);
}

TEST_CASE("lights outside, in glass and on surfaces reach what is seen, and black ones nothing") {
  CHECK(reaching(lit_from({0, 0, 5})) == 1);
  CHECK(reaching(lit_from({2, 0, 0})) == 1);
  CHECK(reaching(lit_from({-1, 0, 1})) == 1);
  CHECK(reaching(lit_from({-2, 1, 1})) == 1);
  scene::Scene black = lit_from({0, 0, 5});
  black.lights[0].color = core::black;
  CHECK(reaching(black) == 0);
}
