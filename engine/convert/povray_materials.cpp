#include "povray_parts.h"
#include "words.h"

#include <algorithm>

namespace halftone::convert {

namespace {

using scene::Color;
using scene::Material;

/// POV-Ray dims the local terms of a pigment by what it transmits, and ours are not: where glass has an
/// albedo, it transmits all but this share, and the finish makes up for the rest.
constexpr double kept = 1.0 / 1024;

std::string pigment(const Color& albedo, double transmit) {
  return "rgbt <" + text(albedo.x) + ", " + text(albedo.y) + ", " + text(albedo.z) + ", " + text(transmit) +
         ">";
}

/// The pattern has two axes, POV-Ray's has three: along the third its cells are so large, and begin so far
/// below, that the world is in one of them.
std::string checkered(const scene::World& world, const Material& material, double transmit) {
  const scene::Checker& checker = *material.checker;
  const int third = 3 - checker.axis_a - checker.axis_b;
  core::Vec3 size{checker.size}, begin{0};
  size[third] = 1e6 * std::max(world.extent, 1.0);
  begin[third] = -0.5 * size[third];
  return "checker " + pigment(material.diffuse, transmit) + ", " + pigment(checker.color, transmit) +
         " scale " + vector_of(size) + " translate " + vector_of(begin);
}

std::string texture(const scene::World& world, const Material& material) {
  const bool has_albedo = material.diffuse != core::black || material.checker;
  const double transmit = material.glass ? (has_albedo ? 1 - kept : 1) : 0;
  const double share = material.glass && has_albedo ? 1 / kept : 1;
  const double highlight = (material.specular.x + material.specular.y + material.specular.z) / 3;
  std::string result = "  texture {\n    pigment { ";
  result += material.checker ? checkered(world, material, transmit) : pigment(material.diffuse, transmit);
  result += " }\n    finish { ambient " + text(share) + " diffuse " + text(share);
  if (highlight > 0) result += " phong " + text(highlight) + " phong_size " + text(material.shininess);
  if (material.glass)
    result += " reflection { 0 1 fresnel on } conserve_energy";
  else if (material.mirror != core::black)
    result += " reflection { rgb " + vector_of(material.mirror) + " }";
  return result + " }\n  }\n";
}

/// Glass has local terms from outside alone.
const char* const inner_texture =
    "  interior_texture {\n    pigment { rgbt 1 }\n"
    "    finish { ambient 0 diffuse 0 reflection { 0 1 fresnel on } conserve_energy }\n  }\n";

/// exp(-absorption * length) is what an interior's fade_power of 1000 and above does: with it, POV-Ray
/// multiplies by exp(-(1 - fade_color) * length / fade_distance), per channel, with no more to compute than
/// that. Absorbing `media` would be sampled along every ray, and be slower for the same thing.
std::string interior(const scene::Glass& glass) {
  std::string result = "  interior { ior " + text(glass.ior);
  const double strongest = core::max_component(glass.absorption);
  if (strongest > 0)
    result += " fade_power 1001 fade_distance " + text(1 / strongest) + " fade_color rgb " +
              vector_of(1.0 - glass.absorption / strongest);
  return result + " }\n";
}

} // namespace

std::string povray_material(const scene::World& world, int index) {
  const Material& material = world.materials[index];
  std::string result = "#declare material_" + std::to_string(index) + " = material {\n";
  result += texture(world, material);
  if (material.glass) result += inner_texture + interior(*material.glass);
  return result + "}\n";
}

} // namespace halftone::convert
