#pragma once
// Which lights have to be looked at.

#include <halftone/scene/world.h>

#include <vector>

namespace halftone::shadow {

/// The lights that can reach something an eye ray sees, in their order. Left out are black ones, and those
/// inside opaque solids, which light only the inner walls, unless the eye is in there too.
std::vector<scene::Light> reaching_lights(const scene::World& world);

} // namespace halftone::shadow
