#pragma once
// Recordings for the tests: of random streams, and of text.

#include "../protocol/random_message.h"

#include <halftone/recording/trace.h>

#include <cstdint>
#include <string>
#include <vector>

namespace halftone::test {

using Bytes = std::vector<std::uint8_t>;

/// Up to 24 commands, resets seldom; most rectangles are small and near the top left.
Bytes random_stream(Random& random);

recording::Trace trace_of(Bytes stream);

/// Of a stream in its text form.
recording::Trace trace_of_text(const std::string& text);

} // namespace halftone::test
