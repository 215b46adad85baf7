#include <halftone/shade/albedo.h>

#include <catch2/catch.hpp>

using namespace halftone;
using core::Color;
using core::Vec3;

namespace {

scene::Material checkered(int axis_a, int axis_b, double size) {
  scene::Material material;
  material.diffuse = {1, 0, 0};
  material.checker = scene::Checker{{0, 1, 0}, size, axis_a, axis_b};
  return material;
}

bool is_odd(const scene::Material& material, const scene::Face& face, const Vec3& position,
            const Vec3& normal) {
  return shade::albedo(material, shade::cell(material, face, position, normal)) == material.checker->color;
}

} // namespace

TEST_CASE("a checker takes its colour where the sum of the cells is odd, below zero too") {
  const auto material = checkered(0, 1, 0.5);
  const scene::Face face;
  const Vec3 up{0, 0, 1};
  CHECK_FALSE(is_odd(material, face, {0.25, 0.25, 9}, up));
  CHECK(is_odd(material, face, {0.75, 0.25, 9}, up));
  CHECK_FALSE(is_odd(material, face, {0.75, 0.75, 9}, up));
  CHECK(is_odd(material, face, {-0.25, 0.25, 9}, up));
  CHECK_FALSE(is_odd(material, face, {-0.25, -0.25, 9}, up));
  CHECK(is_odd(checkered(1, 2, 1), face, {0.5, 0.5, 1.5}, up));
}

TEST_CASE("on a face in a plane where the pattern changes, the cell just behind the surface counts") {
  // A box from z = 0 to z = 2 with cells of size 1 along z: its floor lies on edge 0, its lid on edge 2.
  scene::Scene scene;
  scene.materials = {scene::Material{}, checkered(0, 2, 1)};
  scene.camera.target = {1, 0, 0};
  scene::Object object;
  object.shape = scene::Box{{0.25, 0.25, 0}, {0.75, 0.75, 2}};
  object.material = 1;
  scene.objects.push_back(object);
  const scene::World world = scene::make_world(scene);
  const scene::Material& material = world.materials[1];
  int flat = 0;
  for (const scene::Face& face : world.bodies[0].faces) {
    if (!face.pattern_edge[1]) continue;
    ++flat;
    const double z = *face.pattern_edge[1];
    for (const double wobble : {-0x1p-52, 0.0, 0x1p-52}) {
      // Seen from above, behind is below: the cell under the lid is 1, the one under the floor is -1.
      CHECK(is_odd(material, face, {0.5, 0.5, z + wobble}, {0, 0, 1}));
      // Seen from below, behind is above: the cell over the floor is 0, the one over the lid is 2.
      CHECK_FALSE(is_odd(material, face, {0.5, 0.5, z + wobble}, {0, 0, -1}));
    }
  }
  CHECK(flat == 2);
}
