#pragma once
// What all rows of a picture share: every body's hull, the faces and regions of the screen that a scanline
// can meet.

#include <halftone/geometry/bounding.h>
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

class Frame {
public:
  /// The world must outlive this.
  explicit Frame(const scene::World& world);

  const scene::World& world;
  view::Screen screen;
  std::vector<geometry::Hull> hulls; ///< one for each body
  std::vector<ScreenFace> faces;
  std::vector<TracedRegion> traced;
  trace::Tracer tracer;
};

} // namespace halftone::scan
