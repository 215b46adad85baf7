// Shadow intervals on a visible interval (Tadamura, Nakamae, Nishita c. 1986, sections 3.2 and 3.4.3): each
// remembers which body casts it and which light is blocked.

#include "stretches.h"

#include "sphere_shadow.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

/// The part of an interval in which one body stands between one light and the face.
struct Shade {
  double left = 0;
  double right = 0;
  int light = 0;
  int caster = 0;
  bool dark = false;
};

std::vector<Shade> shades_on(const Frame& frame, shadow::Shadows& shadows, const Interval& interval,
                             double y) {
  const ScreenFace& face = frame.faces[interval.face];
  std::vector<Shade> shades;
  for (int light = 0; light < static_cast<int>(frame.world.lights.size()); ++light) {
    for (const shadow::Region& region : shadows.on(face.body, face.face, light)) {
      auto extent = view::extent_at(region.outline, y);
      if (!extent) continue;
      bool dark = region.dark;
      if (!region.anywhere) {
        if (const auto exact = exact_sphere_shadow(frame, face, region.caster, light, y, *extent)) {
          extent = exact->extent;
          dark = exact->dark;
          if (!extent) continue;
        }
      }
      const double left = std::max(extent->left, interval.left),
                   right = std::min(extent->right, interval.right);
      if (left < right) shades.push_back({left, right, light, region.caster, dark});
    }
  }
  return shades;
}

} // namespace

bool Stretch::is_uncertain() const {
  return std::any_of(lights.begin(), lights.end(), [](const Lighting& l) { return !l.casters.empty(); });
}

std::vector<Stretch> stretches(const Frame& frame, shadow::Shadows& shadows, const Interval& interval,
                               double y) {
  const std::vector<Shade> shades = shades_on(frame, shadows, interval, y);
  std::vector<double> ends{interval.left, interval.right};
  for (const Shade& shade : shades) ends.insert(ends.end(), {shade.left, shade.right});
  std::sort(ends.begin(), ends.end());

  std::vector<Stretch> result;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (!(ends[i] < ends[i + 1])) continue;
    Stretch stretch{ends[i], ends[i + 1], std::vector<Lighting>(frame.world.lights.size())};
    for (const Shade& shade : shades) {
      if (shade.left > stretch.left || shade.right < stretch.right) continue;
      Lighting& lighting = stretch.lights[shade.light];
      if (shade.dark)
        lighting.dark = true;
      else
        lighting.casters.push_back(shade.caster);
    }
    for (Lighting& lighting : stretch.lights)
      if (lighting.dark) lighting.casters.clear();
    if (!result.empty() && result.back().lights == stretch.lights)
      result.back().right = stretch.right;
    else
      result.push_back(std::move(stretch));
  }
  return result;
}

std::optional<std::vector<double>> pattern_changes(const Frame& frame, const ScreenFace& face, double y,
                                                   double left, double right, int most) {
  const scene::Body& body = frame.world.bodies[face.body];
  const auto& checker = frame.world.materials[body.material].checker;
  std::vector<double> changes;
  if (!checker) return changes;
  // Along the line a coordinate is eye + (d0 + d1 x) / (i0 + i1 x); it has the value v at
  // x = (d0 - (v - eye) i0) / ((v - eye) i1 - d1).
  const view::Linear& inverse_depth = face.inverse_depth;
  const double i0 = inverse_depth.at(0, y), i1 = inverse_depth.a;
  const core::Vec3 d0 = frame.screen.direction(0, y);
  const core::Vec3 d1 = frame.screen.camera().right * (2.0 / frame.screen.camera().width);
  for (const int k : {0, 1}) {
    if (body.faces[face.face].pattern_edge[k]) continue; // the face lies in one cell along this axis
    const int axis = k == 0 ? checker->axis_a : checker->axis_b;
    const double eye = frame.world.camera.eye[axis];
    const auto cells_at = [&](double x) {
      return (eye + (d0[axis] + d1[axis] * x) / (i0 + i1 * x)) / checker->size;
    };
    const auto [low, high] = std::minmax({cells_at(left), cells_at(right)});
    if (!(high - low <= most)) return std::nullopt;
    for (double cell = std::ceil(low); cell <= high; ++cell) {
      const double offset = cell * checker->size - eye;
      const double x = (d0[axis] - offset * i0) / (offset * i1 - d1[axis]);
      if (x > left && x < right) changes.push_back(x);
    }
  }
  if (static_cast<int>(changes.size()) > most) return std::nullopt;
  std::sort(changes.begin(), changes.end());
  return changes;
}

} // namespace halftone::scan
