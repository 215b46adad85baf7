#pragma once
// From world space to the screen: projection and clipping. Screen space: pixels, x right from the left edge,
// y down from the top edge, both continuous.

#include <halftone/scene/world.h>

#include <optional>
#include <vector>

namespace halftone::view {

using core::Vec3;

struct ScreenPoint {
  double x = 0;
  double y = 0;
};

/// A point before the division: right and up in units of the picture's half width and height at depth 1, and
/// the depth along the view direction. On the screen where |right|, |up| <= depth. A point at infinity has
/// finite coordinates too; all may be scaled by any positive number.
struct ClipPoint {
  double right = 0;
  double up = 0;
  double depth = 0;
};

/// A convex region of the screen; counter-clockwise or clockwise, at least three corners.
using ScreenPolygon = std::vector<ScreenPoint>;

/// Where a convex region meets a horizontal line.
struct Extent {
  double left = 0;
  double right = 0;
};

/// a * x + b * y + c over the screen: 1/depth of a plane, for instance.
struct Linear {
  double a = 0, b = 0, c = 0;
  double at(double x, double y) const { return a * x + (b * y + c); }
};

class Screen {
public:
  explicit Screen(const scene::CameraFrame& camera);

  /// A direction from the eye, or a point relative to it.
  ClipPoint clip_point(const Vec3& from_eye) const;

  /// Whether a point is on the screen, and where.
  bool sees(const ClipPoint& point) const;
  ScreenPoint project(const ClipPoint& point) const;

  /// The part of a convex region that is on the screen, which needs no near plane: the four sides of the view
  /// pyramid leave nothing behind the eye. Nothing where fewer than three corners remain.
  std::optional<ScreenPolygon> clipped(std::vector<ClipPoint> corners) const;

  /// 1/depth of a plane, where the eye is not in it.
  std::optional<Linear> inverse_depth(const scene::Plane& plane) const;

  /// Direction through a position, with depth 1: eye + depth * this is the point.
  Vec3 direction(double x, double y) const;

  /// All of it.
  ScreenPolygon whole() const;

  const scene::CameraFrame& camera() const { return camera_; }

private:
  scene::CameraFrame camera_;
  Vec3 right_unit_{0}; ///< camera_.right divided by its squared length
  Vec3 up_unit_{0};
};

/// In square pixels; positive where the corners run clockwise as seen, y pointing down.
double signed_area(const ScreenPolygon& polygon);

/// The extent of a convex polygon at height y, or nothing. Of two polygons that share an edge, to the bit,
/// one ends where the other begins.
std::optional<Extent> extent_at(const ScreenPolygon& polygon, double y);

/// How many chords of a circle leave at most a sagitta (in pixels) between it and them, if it is seen within
/// this distance across and not much foreshortened.
int chords_of(double pixels_across, double sagitta);
constexpr int most_chords = 4096;

/// How far, in pixels, corners of a convex polygon lie outside of another that has about the same outline, at
/// most; 0 where none does. Both as convex_hull gives them.
double excess(const ScreenPolygon& polygon, const ScreenPolygon& over);

/// Whether an edge of one of two convex polygons has all of the other on its outer side. Of a sliver whose
/// area is rounding either side may be taken for that.
bool are_apart(const ScreenPolygon& a, const ScreenPolygon& b);

/// The convex hull (of at least three points that are not on one line), or nothing. Convex to the bit, from
/// its leftmost corner on, and clockwise as seen, y pointing down.
std::optional<ScreenPolygon> convex_hull(std::vector<ScreenPoint> points);

} // namespace halftone::view
