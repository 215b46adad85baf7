#pragma once
// Reading without a message.

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <optional>
#include <string>

namespace halftone::fuzz {

/// Nothing where the text is refused.
inline std::optional<scene::Scene> read(const std::string& text) {
  try {
    return scene::read_toml(text, "fuzz.toml");
  } catch (const core::InputError&) {
    return std::nullopt;
  }
}

} // namespace halftone::fuzz
