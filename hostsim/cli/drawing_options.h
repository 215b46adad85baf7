#pragma once
// What a scene is drawn with, and to which device: the options of all commands that draw.

#include "commands.h"

#include <halftone/link/address.h>
#include <halftone/render/render.h>

#include <chrono>
#include <optional>
#include <string>

namespace halftone::cli {

/// --simd: the widest instruction set that the processor has.
inline constexpr const char* automatic = "auto";

struct DrawingOptions {
  std::string scene;
  std::string mode{render::name(render::Mode::local)};
  std::string show; ///< empty: the picture itself
  std::optional<int> samples;
  std::optional<int> lines;
  std::optional<double> quality;
  int threads = 0;
  std::string simd{automatic};
  std::string device = "mem:";
  double timeout = 10; ///< seconds
};

/// Those that a command can draw to.
enum class Devices { all, with_way_back };

/// To a command, which the options outlive.
void add_scene(Arguments command, DrawingOptions& options);
void add_drawing_options(Arguments command, DrawingOptions& options, Devices devices);

/// Throws ArgumentError for an option that the mode has no use for.
render::Settings settings_of(const DrawingOptions& options);

/// Throws ArgumentError.
link::Address device_of(const DrawingOptions& options);

std::chrono::milliseconds timeout_of(const DrawingOptions& options);

} // namespace halftone::cli
