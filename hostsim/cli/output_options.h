#pragma once
// What is kept of a drawing: the options of all commands that draw, and the files.

#include "commands.h"

#include <halftone/core/vector.h>
#include <halftone/scene/scene.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace halftone::cli {

struct OutputOptions {
  std::string picture; ///< empty: not asked for, as below
  std::string screen;
  std::string radiance;
  std::string recording;
  bool statistics = false;
  bool json = false;
};

/// To a command, which the options outlive.
void add_output_options(Arguments command, OutputOptions& options, const std::string& picture_help);

/// Empty: not asked for.
struct PictureFiles {
  std::filesystem::path picture;
  std::filesystem::path screen;
  std::filesystem::path radiance;
};

/// What those that were asked for are written from: as read back from the device, and as computed.
struct Pictures {
  std::vector<std::uint8_t> picture; ///< of the scene's size
  std::vector<std::uint8_t> screen;  ///< 512 x 512
  std::vector<core::Color> radiance;
};

/// Throws file::WriteError.
void write(const PictureFiles& files, const scene::Image& image, const Pictures& pictures);

} // namespace halftone::cli
