#include "drawing_options.h"

#include <halftone/terminal/limits.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace halftone::cli {

namespace {

constexpr std::array all_modes = {render::Mode::local, render::Mode::scanline, render::Mode::full,
                                  render::Mode::reference};
constexpr std::array all_simds = {core::Simd::baseline, core::Simd::avx2, core::Simd::avx512};
constexpr std::array all_shows = {render::Show::signatures, render::Show::intervals, render::Show::samples,
                                  render::Show::cost};

std::vector<std::string> names_of(const auto& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.emplace_back(render::name(value));
  return names;
}

/// The parser has checked that the name is one of theirs.
auto called(const auto& values, const std::string& name) {
  return *std::find_if(values.begin(), values.end(), [&](auto value) { return render::name(value) == name; });
}

std::vector<std::string> simd_names() {
  std::vector<std::string> names{automatic};
  for (const core::Simd simd : all_simds) names.emplace_back(core::name(simd));
  return names;
}

core::Simd simd_called(const std::string& name) {
  const core::Simd simd =
      *std::find_if(all_simds.begin(), all_simds.end(), [&](auto each) { return core::name(each) == name; });
  if (simd > core::widest_simd())
    throw ArgumentError("--simd: this processor does not have " + name + "; its widest is " +
                        std::string(core::name(core::widest_simd())));
  return simd;
}

} // namespace

void add_scene(Arguments command, DrawingOptions& options) {
  command.add_option("SCENE", options.scene, "Scene file (.toml)").required().type_name("");
}

void add_drawing_options(Arguments command, DrawingOptions& options, Devices devices) {
  command
      .add_option(
          "--mode", options.mode,
          "local: scanlines, and rays where the scene needs them (default); scanline: no rays, glass opaque; "
          "full: rays everywhere; reference: brute force")
      .check(terminal::one_of(names_of(all_modes)))
      .type_name("MODE");
  command
      .add_option("--samples", options.samples,
                  "Samples a pixel along each side for full and reference, up to 1000; 4 and 16 by default")
      .check(terminal::whole(1, 1000))
      .type_name("N");
  command
      .add_option("--lines", options.lines,
                  "The paper's method for local and scanline: so many virtual scanlines a row, up to 1000")
      .check(terminal::whole(1, 1000))
      .type_name("N");
  command
      .add_option("--quality", options.quality,
                  "Error aimed at for local and scanline, in 8-bit levels, up to 64; 0.25 by default")
      .check(terminal::above_zero(64))
      .type_name("Q");
  command
      .add_option(
          "--show", options.show,
          "Paint what the engine decided instead of the picture: signatures, intervals, samples or cost")
      .check(terminal::one_of(names_of(all_shows)))
      .type_name("WHAT");
  command.add_option("--threads", options.threads, "Threads, up to 512; by default one for each processor")
      .check(terminal::whole(1, 512))
      .type_name("N");
  command
      .add_option(
          "--simd", options.simd,
          "Instruction set: auto (default), the widest that the processor has; baseline, avx2 or avx512. "
          "The picture is the same")
      .check(terminal::one_of(simd_names()))
      .type_name("SET");
  command
      .add_option("--device", options.device,
                  std::string("Address of the frame buffer: mem: (default), one inside this program; "
                              "unix:PATH or tcp:HOST:PORT, m508 serve") +
                      (devices == Devices::all
                           ? "; file:PATH or pipe: (standard output), which only take commands: no PNG"
                           : ""))
      .type_name("ADDR");
  command
      .add_option(
          "--timeout", options.timeout,
          "Seconds to wait each time for the device to connect, to take bytes or to answer; over a bad "
          "link beginning, verifying and reading back take ten times as long at most, each, with all "
          "repeats. 10 by default")
      .check(terminal::above_zero(86400))
      .type_name("S");
}

render::Settings settings_of(const DrawingOptions& options) {
  render::Settings settings{.mode = called(all_modes, options.mode),
                            .samples = options.samples,
                            .threads = options.threads,
                            .lines = options.lines};
  if (options.quality) settings.quality = *options.quality;
  if (options.simd != automatic) settings.simd = simd_called(options.simd);
  if (!options.show.empty()) settings.show = called(all_shows, options.show);
  const bool scanned = settings.mode == render::Mode::local || settings.mode == render::Mode::scanline;
  const auto refuse = [&](const char* option, const char* modes) {
    throw ArgumentError(std::string(option) + ": mode " + options.mode + " has no use for it; it is for " +
                        modes);
  };
  if (scanned && settings.samples) refuse("--samples", "modes full and reference");
  if (!scanned && options.simd != automatic) refuse("--simd", "modes local and scanline");
  if (!scanned && settings.lines) refuse("--lines", "modes local and scanline");
  if (options.quality && (!scanned || settings.lines))
    refuse("--quality", "modes local and scanline without --lines");
  if (settings.lines && settings.show == render::Show::signatures)
    throw ArgumentError("--show signatures: there are none with --lines");
  if (!scanned && settings.show) refuse("--show", "modes local and scanline");
  return settings;
}

link::Address device_of(const DrawingOptions& options) {
  try {
    return link::parse_address(options.device);
  } catch (const std::invalid_argument& error) {
    throw ArgumentError("--device: " + std::string(error.what()));
  }
}

std::chrono::milliseconds timeout_of(const DrawingOptions& options) {
  return std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double>(options.timeout));
}

} // namespace halftone::cli
