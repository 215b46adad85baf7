#pragma once
// The albedo of a surface at a point: diffuse, or the pattern's second colour.

#include <halftone/scene/world.h>

#include <cmath>
#include <optional>

namespace halftone::shade {

/// A cell of a pattern: its numbers along the checker's two axes.
struct Cell {
  double a = 0;
  double b = 0;

  /// The albedo there is the checker's.
  bool is_odd() const {
    const double half = (a + b) / 2; // exact, as a and b are integers
    return half != std::floor(half);
  }
};

/// Nothing where the material has no pattern. position: on the face, in world space. normal: the face's
/// normal turned to face the ray; where the face lies in a plane in which the pattern changes, the cell just
/// behind the surface counts.
std::optional<Cell> cell(const scene::Material& material, const scene::Face& face, const core::Vec3& position,
                         const core::Vec3& normal);

/// Of that cell.
inline core::Color albedo(const scene::Material& material, const std::optional<Cell>& cell) {
  return cell && cell->is_odd() ? material.checker->color : material.diffuse;
}

} // namespace halftone::shade
