#pragma once
// The text of framebuffer/buses.toml, as it was when this program was built.

#include <string_view>

namespace halftone::bus {

extern const std::string_view built_in_text;

} // namespace halftone::bus
