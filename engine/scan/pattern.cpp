#include "pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halftone::scan {

namespace {

/// Numbers of cells beyond do not differ by one: the pattern is finer than the coordinates it lies on.
constexpr double last_counted = 0x1p53;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A coordinate of the direction through a position, over the screen.
view::Linear direction_along(const Frame& frame, int axis) {
  const scene::CameraFrame& camera = frame.world.camera;
  return {2 * camera.right[axis] / camera.width, -2 * camera.up[axis] / camera.height,
          camera.forward[axis] - camera.right[axis] + camera.up[axis]};
}

/// Through the hull of some points of the screen, which are asked for by number.
std::array<PatternLines, 2> lines_between(const Frame& frame, const ScreenFace& face, int count,
                                          const auto& corner) {
  const scene::Body& body = frame.world.bodies[face.body];
  const auto& checker = frame.world.materials[body.material].checker;
  std::array<PatternLines, 2> lines{};
  if (!checker) return lines;
  for (const int k : {0, 1}) {
    if (body.faces[face.face].pattern_edge[k]) continue;
    const int axis = k == 0 ? checker->axis_a : checker->axis_b;
    const view::Linear along = direction_along(frame, axis);
    const double eye = frame.world.camera.eye[axis];
    double low = infinity, high = -infinity;
    for (int i = 0; i < count; ++i) {
      const view::ScreenPoint p = corner(i);
      const double place = (eye + along.at(p.x, p.y) / face.inverse_depth.at(p.x, p.y)) / checker->size;
      low = std::min(low, place);
      high = std::max(high, place);
    }
    low = std::floor(low);
    high = std::floor(high);
    const bool is_counted = low <= high && low > -last_counted && high < last_counted;
    lines[k] = is_counted ? PatternLines{low, high} : PatternLines{-infinity, infinity};
  }
  return lines;
}

} // namespace

std::array<PatternLines, 2> pattern_lines(const Frame& frame, const ScreenFace& face, const Piece& piece,
                                          const Pieces& pieces) {
  return lines_between(frame, face, piece.count, [&](int k) { return pieces.corner(piece, k); });
}

bool has_pattern_lines(const Frame& frame, const ScreenFace& face, PixelRange run, int y) {
  const double left = run.begin, right = run.end;
  const std::array<view::ScreenPoint, 4> corners{
      {{left, 1.0 * y}, {right, 1.0 * y}, {right, y + 1.0}, {left, y + 1.0}}};
  const auto lines = lines_between(frame, face, 4, [&](int k) { return corners[k]; });
  return lines[0].count() + lines[1].count() > 0;
}

view::Linear pattern_line(const Frame& frame, const ScreenFace& face, int axis, double cell) {
  const scene::Checker& checker = *frame.world.materials[frame.world.bodies[face.body].material].checker;
  const int coordinate = axis == 0 ? checker.axis_a : checker.axis_b;
  const view::Linear along = direction_along(frame, coordinate);
  const double offset = cell * checker.size - frame.world.camera.eye[coordinate];
  return {along.a - offset * face.inverse_depth.a, along.b - offset * face.inverse_depth.b,
          along.c - offset * face.inverse_depth.c};
}

} // namespace halftone::scan
