#pragma once
// What all rows of a picture share: every body's hull, the faces and regions of the screen that a scanline
// can meet.

#include <halftone/core/small_numbers.h>
#include <halftone/geometry/bounding.h>
#include <halftone/scan/outline.h>
#include <halftone/shade/display.h>
#include <halftone/shadow/shadows.h>
#include <halftone/trace/trace.h>
#include <halftone/view/screen.h>

#include <vector>

namespace halftone::scan {

/// A visible face of a body that is drawn by scanlines.
struct ScreenFace {
  int body = 0;
  int face = 0; ///< index into Body::faces
  view::ScreenPolygon outline;
  view::Linear inverse_depth;
  double top = 0, bottom = 0; ///< least and greatest y
};

/// Where a body that is ray traced may be seen.
struct TracedRegion {
  int body = 0;
  std::vector<view::ScreenPolygon> outlines; ///< their union is convex
  double top = 0, bottom = 0;
};

/// A part of a traced body's own outline: what an eye ray through it may hit first, or, where it is certain,
/// does hit unless something stands before it.
struct TracedShape {
  int body = 0;
  bool certain = false; ///< false: the body may be anywhere in it (the eye is in its hull)
  Outline outline;
};

class Frame {
public:
  /// The world must outlive this. sagitta: between a circle and the chords that replace it, in pixels.
  explicit Frame(const scene::World& world, double sagitta = core::sagitta,
                 core::Simd simd = core::widest_simd());
  Frame(const Frame&) = delete; // its shadows refer to its hulls

  const scene::World& world;
  double sagitta;
  view::Screen screen;
  std::vector<geometry::Hull> hulls;          ///< one for each body
  std::vector<std::vector<int>> casters;      ///< for each light, the bodies that may shadow something
  std::vector<std::vector<int>> light_planes; ///< for each light, the planes in which it lies, ascending
  shadow::Shadows shadows;                    ///< for scanners to copy: nothing is found yet
  std::vector<ScreenFace> faces;
  std::vector<TracedRegion> traced;
  std::vector<Outline> face_outlines; ///< of each of faces
  std::vector<TracedShape>
      traced_shapes;               ///< faces of flat bodies; of round ones the outline, and caps within it
  geometry::BoundsTree shape_rows; ///< row_bounds of face_outlines, then of traced_shapes
  trace::Tracer tracer;
  shade::LevelTable level; ///< to judge by what samples differ
  core::Simd simd;         ///< for kernels
  int hidden_faces = 0;    ///< that look at the eye, but lie wholly behind another; not among faces

  /// Bytes that it takes, without those of the world.
  std::size_t memory() const;

private:
  void drop_hidden();
};

} // namespace halftone::scan
