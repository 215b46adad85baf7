#pragma once
// Random recordings.

#include "../text/random_stream.h"

#include <halftone/recording/trace.h>

namespace halftone::test {

/// Sessions of random streams in pieces of random sizes, empty ones too; recorded states, right ones or any;
/// one in four begins with a state that is not that of power-on, one in four ends cut off.
recording::Trace random_trace(Random& random);

} // namespace halftone::test
