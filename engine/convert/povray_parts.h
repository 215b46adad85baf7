#pragma once
// The parts of a POV-Ray scene.

#include <halftone/scene/world.h>

#include <string>

namespace halftone::convert {

/// As in "<1.0, 2.0, 3.0>".
std::string vector_of(const core::Vec3& v);

/// A body with the texture and interior of its material, "material_N".
std::string povray_body(const scene::World& world, const scene::Body& body);

/// The declaration of "material_N".
std::string povray_material(const scene::World& world, int index);

} // namespace halftone::convert
