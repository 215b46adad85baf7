// The shapes of objects, in the object's own coordinates.

#include "sections.h"

#include "convex.h"
#include "suggestion.h"

#include <algorithm>
#include <numeric>

namespace halftone::scene {

namespace {

Sphere read_sphere(const Table& table) {
  return {vector(table.at("center", "center = [0, 0, 1]")),
          number(table.at("radius", "radius = 1"), Bound::positive)};
}

/// The far end of an axis that starts at base.
Vec3 axis_end(const Field& end, const Vec3& base) {
  const Vec3 point = vector(end);
  if (point == base)
    fail(end, in_quotes(end.key) + " of " + std::string(end.table) + " is at \"base\"",
         "the axis needs a length");
  return point;
}

Frustum read_cylinder(const Table& table) {
  const Vec3 base = vector(table.at("base", "base = [0, 0, 0]"));
  const Vec3 top = axis_end(table.at("top", "top = [0, 0, 1]"), base);
  const double radius = number(table.at("radius", "radius = 1"), Bound::positive);
  return {base, top, radius, radius};
}

Frustum read_cone(const Table& table) {
  const Vec3 base = vector(table.at("base", "base = [0, 0, 0]"));
  const Vec3 apex = axis_end(table.at("apex", "apex = [0, 0, 1]"), base);
  return {base, apex, number(table.at("radius", "radius = 1"), Bound::positive), 0};
}

Frustum read_frustum(const Table& table) {
  const Vec3 base = vector(table.at("base", "base = [0, 0, 0]"));
  const Vec3 top = axis_end(table.at("top", "top = [0, 0, 1]"), base);
  const Field top_radius = table.at("top_radius", "top_radius = 0.5");
  const Frustum frustum{base, top, number(table.at("base_radius", "base_radius = 1"), Bound::not_negative),
                        number(top_radius, Bound::not_negative)};
  if (frustum.base_radius == 0 && frustum.top_radius == 0)
    fail(top_radius, "both radii of frustum are 0", "one of them may be 0, which makes a cone");
  return frustum;
}

Box read_box(const Table& table) {
  const Vec3 min = vector(table.at("min", "min = [0, 0, 0]"));
  const Field far_corner = table.at("max", "max = [1, 1, 1]");
  const Vec3 max = vector(far_corner);
  for (int k = 0; k < 3; ++k)
    if (max[k] <= min[k]) {
      const Value& element = std::get<Value::Array>(far_corner.value.content)[k];
      refuse({element, far_corner.file, far_corner.table, far_corner.key},
             std::string("more than in \"min\" along ") + "xyz"[k],
             max[k] < min[k] ? "swap the two" : "for a flat thing use shape = \"polygon\"");
    }
  return {min, max};
}

Prism read_prism(const Table& table) {
  constexpr int most_sides = 1024; // a ring of these is within 5e-6 of its circle's radius
  Prism prism;
  prism.base = vector(table.at("base", "base = [0, 0, 0]"));
  prism.top = axis_end(table.at("top", "top = [0, 0, 1]"), prism.base);
  prism.radius = number(table.at("radius", "radius = 1"), Bound::positive);
  prism.sides = integer(table.at("sides", "sides = 6"), 3, most_sides);
  if (const auto turn = table.find("turn")) prism.turn = number(*turn);
  return prism;
}

/// What is wrong with a polygon, and what to do about it.
std::pair<std::string, std::string> in_words(PolygonFlaw::Kind kind) {
  switch (kind) {
  case PolygonFlaw::few_vertices:
    return {"has fewer than 3 distinct vertices", "a polygon has 3 corners or more"};
  case PolygonFlaw::on_a_line:
    return {"has all its vertices on a line", "a polygon needs an area"};
  case PolygonFlaw::not_planar:
    return {"is not planar: this vertex is off its plane by more than 1e-6 of the longest edge",
            "split it into triangles"};
  case PolygonFlaw::not_convex:
    return {"is not convex: it turns the other way or crosses itself at this vertex",
            "list the corners once around, and split what is not convex"};
  case PolygonFlaw::winds_further:
    return {"crosses itself: it winds more than once around", "list the corners once around"};
  }
  return {};
}

Polygon read_polygon(const Table& table) {
  const Field field = table.at("vertices", "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]");
  const std::vector<Vec3> vertices = vectors(field);
  Loop loop(vertices.size());
  std::iota(loop.begin(), loop.end(), 0);
  loop = without_repeats(vertices, loop);
  if (const auto flaw = flaw_of(vertices, loop)) {
    const bool at_vertex = flaw->kind == PolygonFlaw::not_planar || flaw->kind == PolygonFlaw::not_convex;
    const Value& place = at_vertex ? std::get<Value::Array>(field.value.content)[flaw->vertex] : field.value;
    const auto [problem, advice] = in_words(flaw->kind);
    fail({place, field.file, field.table, field.key}, "the polygon " + problem, advice);
  }
  return {flattened(vertices, loop)};
}

std::vector<Loop> read_faces(const Field& field, int vertices) {
  std::vector<Loop> faces;
  constexpr std::string_view advice = "write it as in [[0, 1, 2], [0, 2, 3], ...], counting vertices from 0";
  for (const Value& face : array(field, "faces", advice)) {
    Loop loop;
    for (const Value& index : array({face, field.file, field.table, field.key}, "indices", advice))
      loop.push_back(integer({index, field.file, field.table, field.key}, 0, vertices - 1));
    faces.push_back(std::move(loop));
  }
  return faces;
}

std::pair<std::string, std::string> in_words(const PolyhedronFlaw& flaw) {
  const std::string edge =
      "the edge from vertex " + std::to_string(flaw.vertex) + " to vertex " + std::to_string(flaw.vertex2);
  const std::string counting = " (counting from 0)";
  switch (flaw.kind) {
  case PolyhedronFlaw::unused_vertex:
    return {"this vertex belongs to no face", "remove it, or list its faces"};
  case PolyhedronFlaw::bad_face: {
    const auto [problem, advice] = in_words(flaw.polygon.kind);
    return {"this face " + problem, advice};
  }
  case PolyhedronFlaw::open:
    return {"the polyhedron is open: " + edge + " belongs to this face alone" + counting,
            "a solid is closed: each edge belongs to two faces"};
  case PolyhedronFlaw::crowded_edge:
    return {edge + " belongs to more than two faces" + counting, "each edge belongs to two faces"};
  case PolyhedronFlaw::not_convex:
    return {"the polyhedron is not convex: vertices " + std::to_string(flaw.vertex) + " and " +
                std::to_string(flaw.vertex2) + " lie on either side of this face" + counting,
            "build it of several convex ones"};
  case PolyhedronFlaw::flat:
    return {"the polyhedron is flat", "for a flat thing use shape = \"polygon\""};
  case PolyhedronFlaw::folded:
    return {"this face lies over another at " + edge + counting, "list each face of the hull once"};
  }
  return {};
}

Polyhedron read_polyhedron(const Table& table) {
  const Field vertices = table.at("vertices", "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]");
  const Field faces = table.at("faces", "faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]");
  Polyhedron polyhedron;
  polyhedron.vertices = vectors(vertices);
  constexpr std::size_t least = 4; // of vertices, and of faces
  if (polyhedron.vertices.size() < least)
    fail(vertices, "a polyhedron of fewer than 4 vertices", "the simplest has 4 vertices and 4 faces");
  polyhedron.faces = read_faces(faces, static_cast<int>(polyhedron.vertices.size()));
  if (polyhedron.faces.size() < least)
    fail(faces, "a polyhedron of fewer than 4 faces", "the simplest has 4 vertices and 4 faces");
  polyhedron = welded(polyhedron);
  if (const auto flaw = flaw_of(polyhedron)) {
    const bool at_vertex = flaw->kind == PolyhedronFlaw::unused_vertex;
    const Field& list = at_vertex ? vertices : faces;
    const Value& place = std::get<Value::Array>(list.value.content)[at_vertex ? flaw->vertex : flaw->face];
    const auto [problem, advice] = in_words(*flaw);
    fail({place, list.file, list.table, list.key}, problem, advice);
  }
  return polyhedron;
}

/// A shape's word, keys and reader.
struct ShapeKind {
  std::string_view word;
  std::vector<std::string_view> keys;
  Shape (*read)(const Table&);
};

template<auto read>
Shape as_shape(const Table& table) {
  return read(table);
}

const std::vector<ShapeKind>& shape_kinds() {
  static const std::vector<ShapeKind> kinds{
      {"sphere", {"center", "radius"}, as_shape<read_sphere>},
      {"cylinder", {"base", "top", "radius"}, as_shape<read_cylinder>},
      {"cone", {"base", "apex", "radius"}, as_shape<read_cone>},
      {"frustum", {"base", "top", "base_radius", "top_radius"}, as_shape<read_frustum>},
      {"box", {"min", "max"}, as_shape<read_box>},
      {"prism", {"base", "top", "radius", "sides", "turn"}, as_shape<read_prism>},
      {"polyhedron", {"vertices", "faces"}, as_shape<read_polyhedron>},
      {"polygon", {"vertices"}, as_shape<read_polygon>},
  };
  return kinds;
}

auto kind_of(std::string_view word) {
  return std::find_if(shape_kinds().begin(), shape_kinds().end(),
                      [&](const ShapeKind& k) { return k.word == word; });
}

} // namespace

std::vector<std::string_view> keys_of_shape(const Field& word) {
  const std::string& name = text(word);
  if (const auto kind = kind_of(name); kind != shape_kinds().end()) return kind->keys;
  if (name == "hull") fail(word, "shape \"hull\" is not supported yet", "list its faces as a polyhedron");
  if (name == "mesh")
    fail(word, "shape \"mesh\" is not supported yet", "list its faces as polygons or a polyhedron");
  std::vector<std::string_view> words;
  for (const ShapeKind& kind : shape_kinds()) words.push_back(kind.word);
  refuse_word(word, words);
}

Shape read_shape(const std::string& word, const Table& table) { return kind_of(word)->read(table); }

} // namespace halftone::scene
