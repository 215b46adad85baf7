// Phong's term is cos^s of the angle between mirrored light and view, near its peak exp(-s angle^2 / 2). Over
// a piece in which the angle changes by `turn`, its middle misses the mean by up to s turn^2 / 24 of the
// peak. The cosine of diffuse light, over a piece in which the light's direction changes by `turn`, bends by
// up to 2 turn^2: the height over the receiver is one factor, the direction the other; its middle misses the
// mean by up to turn^2 / 12.

#include "variation.h"

#include <halftone/core/rounding.h>
#include <halftone/core/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace halftone::scan {

bool varies(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights,
            const Piece& piece, const Pieces& pieces, double missed) {
  const scene::Body& body = frame.world.bodies[face.body];
  const scene::Face& own = body.faces[face.face];
  const scene::Material& material = frame.world.materials[body.material];
  const core::Vec3& eye = frame.world.camera.eye;
  const auto position = [&](const view::ScreenPoint& p) {
    return eye + frame.screen.direction(p.x, p.y) / face.inverse_depth.at(p.x, p.y);
  };
  const auto normal = [&](const core::Vec3& p) {
    return scene::normal_at(own.rounded ? *body.round : frame.world.surfaces[own.surface], p);
  };
  const core::Vec3 middle = position(pieces.centroid(piece)), facing = normal(middle);
  double reach = 0, bend = 0; // of the piece from its middle: distance, and angle of the normal
  for (int k = 0; k < piece.count; ++k) {
    const core::Vec3 corner = position(pieces.corner(piece, k));
    reach = std::max(reach, glm::length(corner - middle));
    if (own.rounded) bend = std::max(bend, glm::length(normal(corner) - facing));
  }
  const core::Vec3 to_eye = eye - middle;
  // Errors of many pieces add by their squares.
  const double allowed = missed / std::sqrt(pieces.area(piece));
  const core::Vec3 view = glm::normalize(to_eye);
  for (std::size_t light = 0; light < lights.size(); ++light) {
    if (lights[light].dark) continue;
    const core::Vec3 to_light = frame.world.lights[light].position - middle;
    const bool is_behind = (glm::dot(facing, to_light) > 0) != (glm::dot(facing, to_eye) > 0);
    if (is_behind && !own.rounded) continue;
    const double sweep = reach / glm::length(to_light) + bend;
    const double strength = core::max_component(frame.world.lights[light].color) * frame.world.image.exposure;
    if (4 * sweep * sweep * strength > 12 * allowed) return true;
    if (material.specular == core::black) continue;
    const double turn = 2 * (sweep + reach / glm::length(to_eye) + bend);
    const double peak = core::max_component(material.specular) * strength;
    if (material.shininess * turn * turn * peak <= 24 * allowed) continue;
    const core::Vec3 l = glm::normalize(to_light);
    const core::Vec3 mirrored = facing * (2 * glm::dot(facing, l)) - l;
    const double angle = glm::length(mirrored - view); // not below its sine
    // Five standard deviations away the term is below 2^-18 of its peak.
    if (angle - turn < 5 / std::sqrt(material.shininess)) return true;
  }
  return false;
}

// Along a row, a corner's place less its pixel's middle is (d_c w_m - d_m w_c) / (w_c w_m), d being the
// direction through a place and w the inverse depth there. Both are linear, and d_c - d_m, w_c - w_m
// constant, so the numerator is linear too: its length is greatest at an end of the run, and w is least at
// one. A piece's middle and its corners are both that near to the pixel's.
bool may_vary(const Frame& frame, const ScreenFace& face, const std::vector<Lighting>& lights, PixelRange run,
              int y, double missed, Within within) {
  const scene::Material& material = frame.world.materials[frame.world.bodies[face.body].material];
  const core::Vec3& eye = frame.world.camera.eye;
  double farthest = 0, least = std::numeric_limits<double>::infinity();
  std::array<core::Vec3, 2> ends;
  for (const int end : {0, 1}) {
    const view::ScreenPoint middle{(end == 0 ? run.begin : run.end - 1) + 0.5, y + 0.5};
    const core::Vec3 direction = frame.screen.direction(middle.x, middle.y);
    const double inverse = face.inverse_depth.at(middle.x, middle.y);
    ends[end] = eye + direction / inverse;
    for (const double dx : {-0.5, 0.5})
      for (const double dy : {-0.5, 0.5}) {
        const double there = face.inverse_depth.at(middle.x + dx, middle.y + dy);
        const core::Vec3 apart =
            frame.screen.direction(middle.x + dx, middle.y + dy) * inverse - direction * there;
        farthest = std::max(farthest, glm::length(apart));
        least = std::min({least, inverse, there});
      }
  }
  if (!(least > 0)) return true;
  constexpr double rounding = 1 + core::gamma(64);
  const double from_middle = rounding * farthest / (least * least);
  const bool is_pixel = within == Within::pixels;
  const double reach = is_pixel ? from_middle : 2 * from_middle, shift = is_pixel ? 0 : from_middle;
  const core::Vec3 along = ends[1] - ends[0];
  const auto distance_from = [&](const core::Vec3& point) {
    const double squared = glm::dot(along, along);
    const double share = squared > 0 ? std::clamp(glm::dot(point - ends[0], along) / squared, 0.0, 1.0) : 0;
    return glm::length(ends[0] + along * share - point) / rounding - shift;
  };
  const double from_eye = distance_from(eye);
  if (!(from_eye > 0)) return true;
  for (std::size_t light = 0; light < lights.size(); ++light) {
    if (lights[light].dark) continue;
    const double from_light = distance_from(frame.world.lights[light].position);
    if (!(from_light > 0)) return true;
    const double sweep = reach / from_light;
    const double strength = core::max_component(frame.world.lights[light].color) * frame.world.image.exposure;
    if (!(4 * sweep * sweep * strength * rounding <= 12 * missed)) return true;
    if (material.specular == core::black) continue;
    const double turn = 2 * (sweep + reach / from_eye);
    const double peak = core::max_component(material.specular) * strength;
    if (!(material.shininess * turn * turn * peak * rounding <= 24 * missed)) return true;
  }
  return false;
}

} // namespace halftone::scan
