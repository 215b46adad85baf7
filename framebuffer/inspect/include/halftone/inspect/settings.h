#pragma once
// The device's registers by name.

#include <halftone/device/device.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::inspect {

/// Numbers in the order of the operands of the command that sets them.
struct Setting {
  std::string_view name;
  std::vector<std::uint32_t> values;

  bool operator==(const Setting&) const = default;
};

/// All of them, always the same names in the same order: window, position, write_mask, written, shown,
/// read_mask, pan, zoom, blank, border, overlay, cursor, error, error_sequence, errors, commands, skipped.
std::vector<Setting> settings(const device::Registers& registers);

/// As in "0 0 512 512".
std::string text_of(const std::vector<std::uint32_t>& values);

} // namespace halftone::inspect
