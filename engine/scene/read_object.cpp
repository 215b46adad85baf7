// Objects: what all shapes have in common, and what must fit together.

#include "sections.h"

#include "convex.h"
#include "suggestion.h"

#include <halftone/core/elementary.h>
#include <halftone/core/rounding.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace halftone::scene {

namespace {

constexpr std::string_view in_double_brackets = "write [[object]] in double brackets";

/// Keys that every object knows; its shape's follow.
std::vector<std::string_view> with_common_keys(const std::vector<std::string_view>& shape_keys) {
  std::vector<std::string_view> keys{"shape", "name", "material", "trace", "scale", "rotate", "translate"};
  keys.insert(keys.end(), shape_keys.begin(), shape_keys.end());
  return keys;
}

int material_index(const Field& field, const std::vector<Material>& materials) {
  const std::string& name = text(field);
  const auto named = [&](const Material& m) { return m.name == name; };
  const auto first = materials.begin() + 1; // the default has no name to be called by
  if (const auto material = std::find_if(first, materials.end(), named); material != materials.end())
    return static_cast<int>(material - materials.begin());
  std::vector<std::string_view> names;
  for (auto material = first; material != materials.end(); ++material) names.push_back(material->name);
  fail(field, "unknown material " + in_quotes(name),
       did_you_mean(name, names, "define it as [material.NAME]"));
}

/// How far a shape reaches from the origin of its coordinates, and the least of the lengths that must not
/// vanish.
struct Size {
  double reach = 0;
  double least = 0;
};

/// Of a round shape the lengths of its stand-in, too.
struct SizeOf {
  int facets = 0;

  Size operator()(const Sphere& s) const {
    const double ring =
        s.radius * core::sin_cos(std::numbers::pi / std::max(2, facets / 2)).sin; // next to a pole
    return {glm::length(s.center) + s.radius, std::min(s.radius, side(ring, facets))};
  }
  Size operator()(const Frustum& f) const {
    const double larger = std::max(f.base_radius, f.top_radius);
    const double smaller = std::min(f.base_radius, f.top_radius);
    return ringed(f.base, f.top, larger, smaller > 0 ? smaller : larger, facets);
  }
  Size operator()(const Box& b) const {
    const Vec3 edges = b.max - b.min;
    return {std::max(glm::length(b.min), glm::length(b.max)), std::min({edges.x, edges.y, edges.z})};
  }
  Size operator()(const Prism& p) const { return ringed(p.base, p.top, p.radius, p.radius, p.sides); }
  Size operator()(const Polyhedron& p) const { return {farthest(p.vertices), least_width(p)}; }
  Size operator()(const Polygon& p) const {
    Loop loop(p.vertices.size());
    std::iota(loop.begin(), loop.end(), 0);
    return {farthest(p.vertices), width(p.vertices, loop)};
  }

private:
  static double side(double radius, int sides) {
    return 2 * radius * core::sin_cos(std::numbers::pi / sides).sin;
  }
  static Size ringed(const Vec3& base, const Vec3& top, double larger, double smaller, int sides) {
    return {std::max(glm::length(base), glm::length(top)) + larger,
            std::min({glm::distance(base, top), smaller, side(smaller, sides)})};
  }
  static double farthest(const std::vector<Vec3>& points) {
    double reach = 0;
    for (const Vec3& p : points) reach = std::max(reach, glm::length(p));
    return reach;
  }
};

/// Refuses what overflows, underflows or vanishes in its own coordinates' rounding once it is placed.
void check_size(const Table& table, const Object& object, int facets) {
  const Size size = std::visit(SizeOf{facets}, object.shape);
  const double reach = glm::length(object.placement.translate) + object.placement.scale * size.reach;
  const double least = object.placement.scale * size.least;
  const Field place = table.find("scale").value_or(table.at("shape", ""));
  if (reach > largest_number)
    fail(place, "the object reaches farther than 1e60 from the origin", "larger coordinates overflow");
  // Each end of a length is rounded when it is read (1) or calculated as a ring's (8), by scale (1), rotation
  // (5) and translation (1).
  if (std::min(size.least, least) < smallest_number || least <= core::gamma(2 * 16) * reach)
    fail(place, "the object's size is lost in the rounding of its coordinates",
         "make it larger, or move it nearer to the origin");
}

void check_polygon(const Table& table, const Material& material) {
  if (material.glass)
    fail(*table.find("material"), "polygon of glass: material " + in_quotes(material.name) + " has \"ior\"",
         "a polygon has no inside; make it a thin box or another solid");
}

void check_trace(const Table& table, const Object& object, const Material& material) {
  if (object.trace != TraceRule::never) return;
  const Field field = *table.find("trace");
  const bool round =
      std::holds_alternative<Sphere>(object.shape) || std::holds_alternative<Frustum>(object.shape);
  const std::string problem = "trace = \"never\" on ";
  if (!round)
    fail(
        field, problem + "a " + object.shape_name,
        "it is for sphere, cylinder, cone and frustum; what is flat and opaque is not traced under \"auto\"");
  if (material.glass)
    fail(field, problem + "glass", "glass is always traced; remove it or the material's ior");
  if (material.mirror != core::black)
    fail(field, problem + "a mirror", "mirrors are always traced; remove it or the material's mirror");
}

Placement read_placement(const Table& table) {
  Placement placement;
  if (const auto scale = table.find("scale")) placement.scale = number(*scale, Bound::positive);
  if (const auto rotate = table.find("rotate")) placement.rotate = vector(*rotate);
  if (const auto translate = table.find("translate")) placement.translate = vector(*translate);
  return placement;
}

Object read_object(const Field& field, const std::vector<Material>& materials, int facets) {
  const Value::Members& members = members_of(field, in_double_brackets);
  const auto shape =
      std::find_if(members.begin(), members.end(), [](const Member& m) { return m.key == "shape"; });
  if (shape == members.end())
    Table(field, "object", with_common_keys({}), in_double_brackets)
        .at("shape", "shape = \"sphere\" or another");

  Object object;
  const Field word{shape->value, field.file, "object", shape->key};
  const std::vector<std::string_view> shape_keys = keys_of_shape(word);
  object.shape_name = text(word);
  const Table table(field, object.shape_name, with_common_keys(shape_keys), in_double_brackets);
  if (const auto name = table.find("name")) object.name = text(*name);
  if (const auto material = table.find("material")) object.material = material_index(*material, materials);
  if (const auto trace = table.find("trace"))
    object.trace = choice<TraceRule>(
        *trace, {{"auto", TraceRule::automatic}, {"always", TraceRule::always}, {"never", TraceRule::never}});
  object.placement = read_placement(table);
  object.shape = read_shape(object.shape_name, table);

  const Material& material = materials[object.material];
  check_size(table, object, facets);
  if (std::holds_alternative<Polygon>(object.shape)) check_polygon(table, material);
  check_trace(table, object, material);
  return object;
}

} // namespace

std::vector<Object> read_objects(const Field& field, const std::vector<Material>& materials, int facets) {
  std::vector<Object> objects;
  for (const Value& element : array(field, "tables", in_double_brackets))
    objects.push_back(read_object({element, field.file, field.table, field.key}, materials, facets));
  return objects;
}

} // namespace halftone::scene
