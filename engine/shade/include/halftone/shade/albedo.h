#pragma once
// The albedo of a surface at a point: diffuse, or the pattern's second colour.

#include <halftone/scene/world.h>

namespace halftone::shade {

/// position: on the face, in world space. normal: the face's normal turned to face the ray; where the face
/// lies in a plane in which the pattern changes, the cell just behind the surface counts.
core::Color albedo(const scene::Material& material, const scene::Face& face, const core::Vec3& position,
                   const core::Vec3& normal);

} // namespace halftone::shade
