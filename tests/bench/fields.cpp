#include "fields.h"

#include <halftone/core/mixed.h>

#include <cmath>

namespace halftone::bench {

namespace {

using scene::Vec3;

/// Numbers that do not depend on the standard library.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  double uniform(double low, double high) {
    state_ = core::mixed(state_);
    return low + (high - low) * (static_cast<double>(state_ >> 11) * 0x1p-53);
  }
  int pick(int count) { return static_cast<int>(uniform(0, count)); }

private:
  std::uint64_t state_;
};

constexpr double half_side = 10; // of the floor

enum Material { floor_material = 1, first_colour = 2, colours = 4, glass = 6, mirror = 7, materials = 8 };

void add_materials(scene::Scene& built) {
  built.materials.resize(materials);
  built.materials[floor_material].diffuse = {0.8, 0.78, 0.72};
  built.materials[floor_material].checker = scene::Checker{{0.25, 0.3, 0.4}, 2.5, 0, 1};
  for (int i = 0; i < colours; ++i) {
    scene::Material& material = built.materials[first_colour + i];
    material.diffuse = {0.2 + 0.2 * i, 0.7 - 0.1 * i, 0.3 + 0.1 * (i % 2)};
    material.specular = scene::Color{0.2};
    material.shininess = 20;
  }
  built.materials[glass].diffuse = scene::Color{0};
  built.materials[glass].glass = scene::Glass{1.5, {0.2, 0.1, 0.1}};
  built.materials[mirror].diffuse = scene::Color{0.1};
  built.materials[mirror].mirror = scene::Color{0.7};
}

/// Stands on the floor, within `size` of the origin across it, about as high as wide.
scene::Shape shape_of(FieldKind kind, double size, Random& random) {
  const double height = size * random.uniform(0.8, 2);
  const int first = kind == FieldKind::flat ? 3 : 0, count = kind == FieldKind::mixed  ? 5
                                                             : kind == FieldKind::flat ? 2
                                                                                       : 3;
  switch (first + random.pick(count)) {
  case 0:
    return scene::Sphere{{0, 0, 0.8 * size}, 0.8 * size};
  case 1:
    return scene::Frustum{{0, 0, 0}, {0, 0, height}, 0.7 * size, 0.7 * size};
  case 2:
    return scene::Frustum{{0, 0, 0}, {0, 0, height}, size, 0};
  case 3: {
    const double depth = size * random.uniform(0.3, 0.7);
    return scene::Box{{-0.7 * size, -depth, 0}, {0.7 * size, depth, height}};
  }
  default:
    return scene::Polygon{{{-size, 0, 0}, {size, 0, 0}, {0.6 * size, 0, height}, {-0.6 * size, 0, height}}};
  }
}

/// Half of the flat ones stand as the axes do, the others are turned about the vertical.
scene::Object object_of(const Field& field, const Vec3& place, double size, Random& random) {
  scene::Object object;
  object.shape = shape_of(field.kind, size, random);
  object.material = first_colour + random.pick(colours);
  const int special = random.pick(10);
  const bool is_polygon = std::holds_alternative<scene::Polygon>(object.shape);
  if (field.kind == FieldKind::mixed && special == 0 && !is_polygon) object.material = glass;
  if (field.kind == FieldKind::mixed && special == 1) object.material = mirror;
  object.placement.translate = place;
  if (random.pick(2) == 0) object.placement.rotate.z = random.uniform(0, 180);
  return object;
}

} // namespace

scene::Scene make_field(const Field& field) {
  scene::Scene built;
  built.image.width = field.width;
  built.image.height = field.height;
  built.camera.eye = {2, -21, 17};
  built.camera.target = {0, -0.8, 0};
  built.camera.fov = 42;
  built.background = {0.3, 0.4, 0.6};
  built.ambient = scene::Color{0.2};
  built.lights = {{{-12, -9, 20}, scene::Color{0.6}}, {{14, 3, 16}, scene::Color{0.4}}};
  add_materials(built);

  scene::Object floor;
  floor.shape = scene::Polygon{{{-half_side, -half_side, 0},
                                {half_side, -half_side, 0},
                                {half_side, half_side, 0},
                                {-half_side, half_side, 0}}};
  floor.material = floor_material;
  built.objects.push_back(floor);

  Random random(field.seed);
  const int across = static_cast<int>(std::ceil(std::sqrt(field.objects)));
  const double cell = 2 * half_side / across, size = 0.3 * cell;
  for (int k = 0; k < field.objects; ++k) {
    const Vec3 place{-half_side + cell * (k % across + random.uniform(0.35, 0.65)),
                     -half_side + cell * (k / across + random.uniform(0.35, 0.65)), 0};
    built.objects.push_back(object_of(field, place, size, random));
  }
  return built;
}

} // namespace halftone::bench
