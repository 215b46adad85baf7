#pragma once
// Which faces coincide, decided once (the scene format, section 3, "Contact").

#include "place.h"

#include <vector>

namespace halftone::scene {

/// Faces of different objects that coincide get one surface. Returns the surfaces; index_of[body][face]
/// receives the surface of each face. tolerance: distance in scene units below which faces coincide.
std::vector<Surface> share_surfaces(const std::vector<PlacedBody>& bodies, double tolerance,
                                    std::vector<std::vector<int>>& index_of);

/// Largest distance from the plane of any point of a flat face.
double farthest_from(const Plane& plane, const PlacedFace& face);

} // namespace halftone::scene
