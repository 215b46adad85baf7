// Polyhedra: closed, convex, with an inside. In this order: every vertex belongs to a face; every face is a
// convex polygon; every edge has two faces; all vertices are on one side of every face's plane, some of them
// off it; the faces, turned to look outward, pass each edge once each way.
//
// That is enough: the faces lie on the boundary of the vertices' convex hull, and, meeting in pairs on either
// side of their edges, they leave no part of it out.

#include "convex.h"

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace halftone::scene {

namespace {

using Edge = std::pair<int, int>;
using Flaw = std::optional<PolyhedronFlaw>;

/// Calls visit(from, to) for each edge of the loop until it returns a flaw.
template<class Visit>
Flaw first_flaw_along(const Loop& loop, const Visit& visit) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (const Flaw flaw = visit(loop[i], loop[(i + 1) % loop.size()])) return flaw;
  return std::nullopt;
}

Flaw unused_vertex(const Polyhedron& polyhedron) {
  const auto less = [&](int a, int b) {
    const Vec3 &p = polyhedron.vertices[a], &q = polyhedron.vertices[b];
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::set<int, decltype(less)> used(less); // by place: a vertex that repeats another's is used with it
  for (const Loop& face : polyhedron.faces) used.insert(face.begin(), face.end());
  for (int k = 0; k < static_cast<int>(polyhedron.vertices.size()); ++k)
    if (!used.contains(k)) return PolyhedronFlaw{PolyhedronFlaw::unused_vertex, 0, k, 0, {}};
  return std::nullopt;
}

Flaw bad_face(const Polyhedron& polyhedron) {
  for (int f = 0; f < static_cast<int>(polyhedron.faces.size()); ++f)
    if (const auto flaw = flaw_of(polyhedron.vertices, polyhedron.faces[f]))
      return PolyhedronFlaw{PolyhedronFlaw::bad_face, f, flaw->vertex, 0, *flaw};
  return std::nullopt;
}

Flaw unpaired_edge(const Polyhedron& polyhedron) {
  std::map<Edge, int> faces_at;
  for (const Loop& face : polyhedron.faces)
    first_flaw_along(face, [&](int a, int b) {
      ++faces_at[std::minmax(a, b)];
      return Flaw{};
    });
  for (int f = 0; f < static_cast<int>(polyhedron.faces.size()); ++f) {
    const Flaw flaw = first_flaw_along(polyhedron.faces[f], [&](int a, int b) -> Flaw {
      const int count = faces_at.at(std::minmax(a, b));
      if (count == 2) return std::nullopt;
      return PolyhedronFlaw{count == 1 ? PolyhedronFlaw::open : PolyhedronFlaw::crowded_edge, f, a, b, {}};
    });
    if (flaw) return flaw;
  }
  return std::nullopt;
}

/// How far the vertices reach to both sides of a face, and which goes farthest.
struct Sides {
  double below = 0;
  double above = 0;
  int lowest = 0;
  int highest = 0;
};

Sides sides_of(const Polyhedron& polyhedron, const Loop& face) {
  const LoopPlane plane = plane_of(polyhedron.vertices, face);
  Sides sides;
  for (int k = 0; k < static_cast<int>(polyhedron.vertices.size()); ++k) {
    const double height = plane.height(polyhedron.vertices[k]);
    if (-height > sides.below) {
      sides.below = -height;
      sides.lowest = k;
    }
    if (height > sides.above) {
      sides.above = height;
      sides.highest = k;
    }
  }
  return sides;
}

} // namespace

double least_width(const Polyhedron& polyhedron) {
  double least = std::numeric_limits<double>::infinity();
  for (const Loop& face : polyhedron.faces) {
    const Sides sides = sides_of(polyhedron, face);
    least = std::min({least, width(polyhedron.vertices, face), std::max(sides.below, sides.above)});
  }
  return least;
}

std::optional<PolyhedronFlaw> flaw_of(const Polyhedron& polyhedron) {
  for (const auto& find : {unused_vertex, bad_face, unpaired_edge})
    if (const Flaw flaw = find(polyhedron)) return flaw;

  double edge = 0, rounding = 0;
  for (const Loop& face : polyhedron.faces) {
    edge = std::max(edge, longest_edge(polyhedron.vertices, face));
    rounding = std::max(rounding, rounding_of_heights(polyhedron.vertices, face));
  }
  std::map<Edge, int> passed;
  for (int f = 0; f < static_cast<int>(polyhedron.faces.size()); ++f) {
    const Sides sides = sides_of(polyhedron, polyhedron.faces[f]);
    const bool outward = sides.above <= sides.below;
    if (std::max(sides.above, sides.below) <= rounding)
      return PolyhedronFlaw{PolyhedronFlaw::flat, f, 0, 0, {}};
    if (std::min(sides.above, sides.below) > core::planar_slack * edge)
      return PolyhedronFlaw{PolyhedronFlaw::not_convex, f, sides.lowest, sides.highest, {}};
    const Flaw flaw = first_flaw_along(polyhedron.faces[f], [&](int a, int b) -> Flaw {
      const Edge direction = outward ? Edge{a, b} : Edge{b, a};
      if (++passed[direction] == 1) return std::nullopt;
      return PolyhedronFlaw{PolyhedronFlaw::folded, f, a, b, {}};
    });
    if (flaw) return flaw;
  }
  return std::nullopt;
}

} // namespace halftone::scene
