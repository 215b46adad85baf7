#pragma once
// What makes a polygon or polyhedron of a file unfit (the scene format, section 1), apart from any file.
//
// Author's numbers are rounded, so a polygon is planar and convex up to core::planar_slack of its longest
// edge. Areas and thicknesses, on the other hand, are compared with their own rounding. Every comparison is
// of lengths with lengths, so decisions do not change when a shape is scaled by a power of two. Coordinates
// are up to 1e60 and longest edges at least 1e-60, so no product over- or underflows.

#include <halftone/scene/scene.h>

#include <optional>
#include <vector>

namespace halftone::scene {

/// Indices of vertices in their order around a face.
using Loop = std::vector<int>;

/// The loop without those that repeat the place of the one before (the first comes after the last).
Loop without_repeats(const std::vector<Vec3>& vertices, const Loop& loop);

double longest_edge(const std::vector<Vec3>& vertices, const Loop& loop);

/// Newell's plane (I. Sutherland, R. Sproull, R. Schumacker 1974) of a loop, through the mean of its
/// vertices. Kept relative to the first, so that a small loop far from the origin loses nothing.
struct LoopPlane {
  Vec3 first{0};
  Vec3 mean{0}; ///< minus first
  Vec3 normal{0};
  double twice_area = 0; ///< 0 where the normal has no meaning

  double height(const Vec3& p) const { return glm::dot(normal, p - first - mean); }
};

LoopPlane plane_of(const std::vector<Vec3>& vertices, const Loop& loop);

/// At least a quarter of the least distance between parallel lines in the loop's plane that have it between
/// them, and at most that distance.
double width(const std::vector<Vec3>& vertices, const Loop& loop);

/// What rounding may add to the height of one of the loop's own vertices over a plane through others.
double rounding_of_heights(const std::vector<Vec3>& vertices, const Loop& loop);

struct PolygonFlaw {
  enum Kind {
    few_vertices,  ///< fewer than 3 places, or no edge of 1e-60
    on_a_line,     ///< all vertices, up to rounding
    not_planar,    ///< the vertex is more than the slack off the Newell plane
    not_convex,    ///< turns the other way at the vertex, by more than the slack, or turns back
    winds_further, ///< turns one way all along, but more than once around
  };
  Kind kind = few_vertices;
  int vertex = 0; ///< index into the vertices; the loop's first where the kind names none
};

/// The first flaw in the order of PolygonFlaw::Kind, if there is any. loop: without repeats.
std::optional<PolygonFlaw> flaw_of(const std::vector<Vec3>& vertices, const Loop& loop);

/// A flawless polygon's vertices in order, projected onto its Newell plane where they are off it by more than
/// the rounding of their own coordinates. Others stay as they are, so that neighbours still share them.
std::vector<Vec3> flattened(const std::vector<Vec3>& vertices, const Loop& loop);

struct PolyhedronFlaw {
  enum Kind {
    unused_vertex,
    bad_face,     ///< `polygon` says why
    open,         ///< the edge has one face
    crowded_edge, ///< the edge has more than two faces
    not_convex,   ///< the two vertices are on either side of the face, both by more than the slack
    flat,         ///< no inside, up to rounding
    folded,       ///< two faces lie over each other at the edge
  };
  Kind kind = open;
  int face = 0;
  int vertex = 0;  ///< of unused_vertex and not_convex; one end of the edge
  int vertex2 = 0; ///< of not_convex; the edge's other end
  PolygonFlaw polygon;
};

/// Loops whose indices name the first vertex of each place, without repeats.
Polyhedron welded(const Polyhedron& polyhedron);

/// The least width of a face, or height of the solid over one: what moving a vertex can make vanish.
double least_width(const Polyhedron& polyhedron);

/// A flaw, if there is any. Indices must be in range, the loops welded. Time grows as vertices times faces.
std::optional<PolyhedronFlaw> flaw_of(const Polyhedron& polyhedron);

} // namespace halftone::scene
