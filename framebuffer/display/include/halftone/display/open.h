#pragma once
// Displays by name, from modules that are loaded on demand.

#include <halftone/display/display.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::display {

/// As in "window" or "vnc:127.0.0.1:5901".
struct Choice {
  std::string name;
  std::string where; ///< what stands behind the colon; empty: the display's own default

  bool operator==(const Choice&) const = default;
};

/// The names that open() knows, built or not.
std::vector<std::string> names();

/// Throws std::invalid_argument with advice for a name that is not known.
Choice parse_choice(std::string_view text);

/// Loads the module halftone-display-NAME.so from the first of the folders that has it, and opens its
/// display. The module stays loaded to the end of the process. Throws DisplayError, which names the package
/// that is missing where the module or a library of it is; std::invalid_argument for what stands behind a
/// name.
std::unique_ptr<Display> open(const Choice& choice, const std::vector<std::filesystem::path>& folders);

/// Where modules are for the program that runs: beside it, as in the build folder, or where they are
/// installed.
std::vector<std::filesystem::path> module_folders();

} // namespace halftone::display
