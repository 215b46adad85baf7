#pragma once
// Words for lint.

#include <halftone/device/device.h>

#include <halftone/protocol/message.h>

#include <cstdint>
#include <string>

namespace halftone::inspect {

/// A rejection: what the device found wrong, and what it would have taken.
struct Explanation {
  std::string what;
  std::string advice;
};
Explanation explain(const protocol::Rejection& rejection);

/// Why a command can have changed nothing.
std::string why_redundant(const protocol::Message& message);

/// As in "1 pixel", "2 pixels".
std::string of_them(std::uint64_t count, const std::string& name);

/// As in "200 x 100 at (56, 68)".
std::string text_of(const device::Rectangle& rectangle);

} // namespace halftone::inspect
