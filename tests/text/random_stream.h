#pragma once
// Random streams of everything that a stream can hold.

#include "../protocol/random_message.h"

#include <cstdint>
#include <vector>

namespace halftone::test {

/// Messages of this direction, some of the other, frames that are refused, fill, bytes that are no frame; one
/// in two is damaged besides.
std::vector<std::uint8_t> random_stream(Random& random, protocol::Direction direction);

} // namespace halftone::test
