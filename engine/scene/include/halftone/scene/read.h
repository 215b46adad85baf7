#pragma once
// Reading scene files. Validation happens here, once: a Scene that was returned is valid.

#include <halftone/scene/scene.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace halftone::scene {

/// Reads a scene file (.toml). Throws core::InputError with file, line, column and advice.
Scene read_scene(const std::filesystem::path& file);

/// Reads TOML text as if it were the contents of the file called name.
Scene read_toml(std::string_view text, const std::string& name);

} // namespace halftone::scene
