#pragma once
// What several commands say of the analyses of framebuffer/inspect.

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>
#include <halftone/recording/walk.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace halftone::m508 {

/// As in `command 5 (byte 69, session 1, sequence 5, section "sun")`.
std::string place_of(const inspect::Reference& command);

/// As in "1 pixel", "2 pixels".
std::string of_them(std::uint64_t count, const std::string& name);

/// A checksum, in eight digits.
std::string in_hexadecimal(std::uint32_t number);

/// How a device does not come to what was recorded; `file` is the recording.
std::string text_of(const std::string& file, const recording::Departure& departure);

/// Number, offset, session, sequence, section (null where there is none), text.
nlohmann::ordered_json json_of(const inspect::Reference& command);

/// An array of three numbers, or, of the overlay, one.
nlohmann::ordered_json json_of(device::Plane plane, const device::Pixel& value);

/// An array [x, y, width, height].
nlohmann::ordered_json json_of(const device::Rectangle& area);

} // namespace halftone::m508
