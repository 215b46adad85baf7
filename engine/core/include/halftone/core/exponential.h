#pragma once
// exp() of the channels of a colour at once, by the processor's vectors.

#include <halftone/core/simd.h>
#include <halftone/core/vector.h>

namespace halftone::core {

/// e^x of each coordinate, to the bit what exp() of elementary.h says.
using ExpOfThree = Vec3 (*)(const Vec3& x);

/// The one for an instruction set, which the processor must have.
ExpOfThree exp_of_three(Simd simd);

} // namespace halftone::core
