#pragma once
// Reading scene files. Validation happens here, once: a Scene that was returned is valid.
//
// What the format leaves open is decided so: every number is finite and up to 1e60 in magnitude, also after
// an object is placed; numbers that must be positive are at least 1e-60, other coordinates and angles nearer
// to 0 are 0, and no shape is lost in the rounding of its coordinates. Albedos and `mirror` are 0 to 1, as is
// `cutoff`; radiances, `specular`, `shininess` and `absorption` are not negative. `depth` is 1 to 1000,
// `facets` and `sides` are 3 to 1024. Keys that only glass heeds are legal without `ior`.

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
