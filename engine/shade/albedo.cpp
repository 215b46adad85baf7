#include <halftone/shade/albedo.h>

#include <cmath>

namespace halftone::shade {

namespace {

/// Number of the cell along one axis.
double cell_of(double position, double size, std::optional<double> edge, double normal) {
  if (!edge) return std::floor(position / size);
  return normal < 0 ? *edge : *edge - 1; // behind the surface is where the normal points away from
}

} // namespace

std::optional<Cell> cell(const scene::Material& material, const scene::Face& face, const core::Vec3& position,
                         const core::Vec3& normal) {
  if (!material.checker) return std::nullopt;
  const scene::Checker& checker = *material.checker;
  return Cell{cell_of(position[checker.axis_a], checker.size, face.pattern_edge[0], normal[checker.axis_a]),
              cell_of(position[checker.axis_b], checker.size, face.pattern_edge[1], normal[checker.axis_b])};
}

} // namespace halftone::shade
