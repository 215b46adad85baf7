#pragma once
// Buses by name, from a table that users can edit.

#include <halftone/device/clock.h>

#include <string>
#include <string_view>
#include <vector>

namespace halftone::bus {

/// The buses of a table, in its order. Throws core::InputError with file, line and column.
std::vector<device::Bus> parse_buses(std::string_view toml, const std::string& file);

/// Those of framebuffer/buses.toml, as it was when this program was built; from the slowest to the fastest.
std::vector<device::Bus> built_in();

/// Throws ArgumentError where there is no bus of that name.
const device::Bus& find_bus(const std::vector<device::Bus>& buses, const std::string& name);

} // namespace halftone::bus
