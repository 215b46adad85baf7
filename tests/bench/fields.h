#pragma once
// Fields of many small objects on a floor, for cost against the number of objects. Objects stand one in each
// cell of a grid and grow smaller as there are more, so that they cover about the same share of the picture.

#include <halftone/scene/scene.h>

#include <cstdint>

namespace halftone::bench {

enum class FieldKind {
  round, ///< spheres, cylinders, cones
  flat,  ///< boxes, and polygons that stand upright
  mixed, ///< all of these, one in ten of glass and one in ten a mirror
};

struct Field {
  FieldKind kind = FieldKind::flat;
  int objects = 100; ///< without the floor
  int width = 320, height = 240;
  std::uint64_t seed = 1;
};

/// The same scene for the same field, to the bit: two lights, a checkered floor, opaque objects but for
/// mixed.
scene::Scene make_field(const Field& field);

} // namespace halftone::bench
