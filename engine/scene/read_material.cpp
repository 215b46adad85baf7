#include "sections.h"

#include "suggestion.h"

#include <array>

namespace halftone::scene {

namespace {

/// Two axes by their letters, in any order.
std::array<int, 2> axes(const Field& field) {
  constexpr std::string_view letters = "xyz";
  const std::string& pair = text(field);
  const auto index = [&](std::size_t i) {
    return i < pair.size() ? letters.find(pair[i]) : std::string::npos;
  };
  if (pair.size() != 2 || index(0) == std::string::npos || index(1) == std::string::npos ||
      index(0) == index(1))
    refuse(field, "two different letters of x, y and z", "\"xy\" is the pattern of a floor");
  return {static_cast<int>(index(0)), static_cast<int>(index(1))};
}

Checker read_checker(const Field& field) {
  const Table table(field, "checker", {"color", "size", "axes"},
                    "write checker = { color = [0.2, 0.2, 0.2] }");
  Checker checker;
  checker.color =
      color(table.at("color", "color = [0.2, 0.2, 0.2], the albedo of the odd cells"), Bound::fraction);
  if (const auto size = table.find("size")) checker.size = number(*size, Bound::positive);
  if (const auto letters = table.find("axes")) {
    const auto [a, b] = axes(*letters);
    checker.axis_a = a;
    checker.axis_b = b;
  }
  return checker;
}

// Albedos and mirror are shares of what arrives, so from 0 to 1: above that a surface would give more than it
// gets, and what the author had in mind is nearly always a colour of 0 to 255. A highlight's colour is a
// factor on a formula that conserves nothing, and radiances have no limit; both may exceed 1. Nothing is
// negative. `absorption` and `opaque` without `ior` are legal: they wait for the line that makes the material
// glass.
Material read_material(const Field& field) {
  const std::string name(field.key);
  if (name.empty()) fail(field, "a material without a name", "write [material.NAME]");
  const Table table(field, "material " + in_quotes(name),
                    {"diffuse", "specular", "shininess", "mirror", "ior", "absorption", "opaque", "checker"},
                    "materials have names: write [material.NAME], then the keys");
  const auto ior = table.find("ior");
  const auto mirror = table.find("mirror");
  if (ior && mirror)
    fail(*mirror, "\"mirror\" together with \"ior\" in material " + in_quotes(name),
         "glass reflects by its index of refraction; remove one of the two");

  Material material;
  material.name = name;
  if (ior) {
    material.glass = Glass{number(*ior, Bound::positive), core::black};
    material.diffuse = core::black;
  }
  if (const auto diffuse = table.find("diffuse")) material.diffuse = color(*diffuse, Bound::fraction);
  if (const auto specular = table.find("specular")) material.specular = color(*specular, Bound::not_negative);
  if (const auto shininess = table.find("shininess"))
    material.shininess = number(*shininess, Bound::not_negative);
  if (mirror) material.mirror = color(*mirror, Bound::fraction);
  if (const auto absorption = table.find("absorption")) {
    const Color coefficient = color(*absorption, Bound::not_negative);
    if (material.glass) material.glass->absorption = coefficient;
  }
  if (const auto opaque = table.find("opaque")) material.opaque = color(*opaque, Bound::fraction);
  if (const auto checker = table.find("checker")) material.checker = read_checker(*checker);
  return material;
}

} // namespace

std::vector<Material> read_materials(const std::optional<Field>& field) {
  std::vector<Material> materials(1); // the default
  if (!field) return materials;
  constexpr std::string_view advice = "materials have names: write [material.NAME]";
  for (const Member& member : members_of(*field, advice))
    materials.push_back(read_material({member.value, field->file, field->key, member.key}));
  return materials;
}

} // namespace halftone::scene
