#pragma once
// Which bodies have to be asked whether they shadow something.

#include <halftone/geometry/bounding.h>

#include <vector>

namespace halftone::shadow {

/// For each light, in ascending order, the bodies that can keep it from a point which nothing else keeps it
/// from. Left out is what lies wholly in the shadow of one large opaque face. hulls: one for each body.
std::vector<std::vector<int>> casters_by_light(const scene::World& world,
                                               const std::vector<geometry::Hull>& hulls);

} // namespace halftone::shadow
