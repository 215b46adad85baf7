// halftone render: scene file to rows, rows through the frame buffer, and the picture as it is read back from
// there.

#include "commands.h"
#include "pfm.h"
#include "progress.h"
#include "render_report.h"
#include <halftone/terminal/growing_file.h>
#include <halftone/terminal/limits.h>
#include <halftone/terminal/output_file.h>

#include <halftone/device/device.h>
#include <halftone/driver/driver.h>
#include <halftone/file/write.h>
#include <halftone/link/link.h>
#include <halftone/link/recording_link.h>
#include <halftone/png/png.h>
#include <halftone/recording/write.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace halftone::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::array all_simds = {core::Simd::baseline, core::Simd::avx2, core::Simd::avx512};
constexpr std::array all_modes = {render::Mode::local, render::Mode::scanline, render::Mode::full,
                                  render::Mode::reference};
constexpr std::array all_shows = {render::Show::signatures, render::Show::intervals, render::Show::samples,
                                  render::Show::cost};

struct Options {
  std::string scene;
  std::string picture; ///< empty: the scene's name with .png in the current folder
  std::string screen;  ///< empty: not asked for, as below
  std::string radiance;
  std::string mode{render::name(render::Mode::local)};
  std::string show; ///< empty: the picture itself
  std::optional<int> samples;
  std::optional<int> lines;
  std::optional<double> quality;
  int threads = 0;
  std::string simd = "auto";
  std::string device = "mem:";
  double timeout = 10;   ///< seconds
  std::string recording; ///< empty: not asked for
  bool statistics = false;
  bool json = false;
};

std::vector<std::string> names_of(const auto& values) {
  std::vector<std::string> names;
  for (const auto value : values) names.emplace_back(render::name(value));
  return names;
}

/// The parser has checked that the name is one of theirs.
auto called(const auto& values, const std::string& name) {
  return *std::find_if(values.begin(), values.end(), [&](auto value) { return render::name(value) == name; });
}

core::Simd simd_called(const std::string& name) {
  const core::Simd simd =
      *std::find_if(all_simds.begin(), all_simds.end(), [&](auto each) { return core::name(each) == name; });
  if (simd > core::widest_simd())
    throw ArgumentError("--simd: this processor does not have " + name + "; its widest is " +
                        std::string(core::name(core::widest_simd())));
  return simd;
}

/// Throws ArgumentError for an option that the mode has no use for.
render::Settings settings_of(const Options& options) {
  render::Settings settings{.mode = called(all_modes, options.mode),
                            .samples = options.samples,
                            .threads = options.threads,
                            .lines = options.lines};
  if (options.quality) settings.quality = *options.quality;
  if (options.simd != "auto") settings.simd = simd_called(options.simd);
  if (!options.show.empty()) settings.show = called(all_shows, options.show);
  const bool scanned = settings.mode == render::Mode::local || settings.mode == render::Mode::scanline;
  const auto refuse = [&](const char* option, const char* modes) {
    throw ArgumentError(std::string(option) + ": mode " + options.mode + " has no use for it; it is for " +
                        modes);
  };
  if (scanned && settings.samples) refuse("--samples", "modes full and reference");
  if (!scanned && settings.lines) refuse("--lines", "modes local and scanline");
  if (options.quality && (!scanned || settings.lines))
    refuse("--quality", "modes local and scanline without --lines");
  if (settings.lines && settings.show == render::Show::signatures)
    throw ArgumentError("--show signatures: there are none with --lines");
  if (!scanned && settings.show) refuse("--show", "modes local and scanline");
  return settings;
}

struct Outputs {
  fs::path picture; ///< empty where the device cannot give it back
  fs::path screen;
  fs::path radiance;
  fs::path commands; ///< what a device that is a file is sent to
  fs::path recording;
};

link::Address device_of(const Options& options) {
  try {
    return link::parse_address(options.device);
  } catch (const std::invalid_argument& error) {
    throw ArgumentError("--device: " + std::string(error.what()));
  }
}

/// What was asked for must be possible with a device that only takes.
void check_one_way(const Options& options, const link::Address& device) {
  const auto* file = std::get_if<link::FileAddress>(&device);
  const auto refuse = [&](const std::string& option) {
    throw ArgumentError(option + ": " + link::name(device) +
                        " only takes commands, and gives no picture back; the picture in them is read with: "
                        "m508 replay " +
                        (file != nullptr ? file->path : "FILE") + " -o OUT.png");
  };
  if (!options.picture.empty()) refuse("-o");
  if (!options.screen.empty()) refuse("--screen");
  if (file != nullptr) return;
  if (options.statistics) throw ArgumentError("--stats: standard output is for the commands");
  if (options.json) throw ArgumentError("--json: standard output is for the commands");
}

/// Finds what would fail after minutes of rendering: files that cannot be written, or that are each other or
/// the scene.
Outputs check_outputs(const Options& options, const link::Address& device) {
  const fs::path scene(options.scene);
  Outputs outputs{{}, options.screen, options.radiance, {}, options.recording};
  if (link::has_way_back(device))
    outputs.picture = options.picture.empty() ? fs::path(scene.stem()) += ".png" : fs::path(options.picture);
  if (const auto* file = std::get_if<link::FileAddress>(&device)) outputs.commands = file->path;
  terminal::check_outputs({{"-o", outputs.picture},
                           {"--screen", outputs.screen},
                           {"--float", outputs.radiance},
                           {"--device", outputs.commands},
                           {"--record", outputs.recording}},
                          {scene});
  return outputs;
}

ExitCode run(const Options& options) {
  const render::Settings settings = settings_of(options);
  const link::Address device = device_of(options);
  if (!link::has_way_back(device)) check_one_way(options, device);
  const scene::Scene scene = scene::read_scene(options.scene);
  const Outputs outputs = check_outputs(options, device);
  const int width = scene.image.width, height = scene.image.height;

  const auto timeout =
      std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double>(options.timeout));
  std::unique_ptr<link::Link> link = link::open(device, timeout);
  std::optional<terminal::GrowingFile> recording_file;
  std::optional<recording::Writer> recording;
  link::RecordingLink* recording_link = nullptr;
  if (!outputs.recording.empty()) {
    recording_file.emplace(outputs.recording);
    // The driver begins with a reset, so that it does not matter what the device was before.
    recording.emplace([&](std::span<const std::uint8_t> bytes) { recording_file->append(bytes); },
                      device::Device());
    auto recorded = std::make_unique<link::RecordingLink>(std::move(link), *recording, "halftone render");
    recording_link = recorded.get();
    link = std::move(recorded);
  }
  driver::Driver driver(*link, timeout);
  driver.begin(width, height);

  std::vector<core::Color> radiance;
  render::Statistics statistics;
  {
    Progress progress(height);
    statistics = render::render(scene, settings, [&](const render::Row& row) {
      driver.send_row(row.y, row.rgb);
      if (!outputs.radiance.empty())
        radiance.insert(radiance.end(), row.radiance.begin(), row.radiance.end());
      progress.report(row.y + 1);
    });
  }
  driver.finish();

  const auto encoding =
      scene.image.transfer == scene::Transfer::srgb ? png::Encoding::srgb : png::Encoding::linear;
  png::Picture picture{width, height, {}}, screen{512, 512, {}};
  if (!outputs.picture.empty()) picture.rgb = driver.read_picture();
  if (!outputs.screen.empty()) screen.rgb = driver.read_screen();
  if (recording_link != nullptr) recording_link->end("done");
  {
    const terminal::SignalShelter shelter;
    link->finish();
    if (!outputs.picture.empty()) png::write(outputs.picture, picture, encoding);
    if (!outputs.screen.empty()) png::write(outputs.screen, screen, encoding);
    if (!outputs.radiance.empty()) {
      const std::string map = encode_pfm(width, height, radiance);
      file::write_whole(outputs.radiance, std::as_bytes(std::span(map)));
    }
  }
  if (!link->has_way_back())
    std::cerr << "halftone: sent to " << link::name(device) << ", which gives no picture back: no PNG\n";

  const RenderReport report{width, height, statistics, driver.seconds()};
  if (options.json)
    std::cout << as_json(report);
  else if (options.statistics)
    std::cout << for_people(report);
  return ExitCode::done;
}

} // namespace

Command add_render(Arguments program) {
  Arguments command = program.add_subcommand("render", "Render a scene through the frame buffer to a PNG");
  const auto options = std::make_shared<Options>();
  command.add_option("SCENE", options->scene, "Scene file (.toml)").required().type_name("");
  command
      .add_option(
          "-o,--output", options->picture,
          "The picture as read back from the device; by default the scene's name with .png in the current "
          "folder")
      .type_name("OUT.png");
  command.add_option("--screen", options->screen, "The whole 512 x 512 screen as shown").type_name("OUT.png");
  command
      .add_option("--float", options->radiance,
                  "Radiance before exposure and rounding, as a portable float map")
      .type_name("OUT.pfm");
  command
      .add_option(
          "--mode", options->mode,
          "local: scanlines, and rays where the scene needs them (default); scanline: no rays, glass opaque; "
          "full: rays everywhere; reference: brute force")
      .check(terminal::one_of(names_of(all_modes)))
      .type_name("MODE");
  command
      .add_option("--samples", options->samples,
                  "Samples a pixel along each side for full and reference, up to 1000; 4 and 16 by default")
      .check(terminal::whole(1, 1000))
      .type_name("N");
  command
      .add_option("--lines", options->lines,
                  "The paper's method for local and scanline: so many virtual scanlines a row, up to 1000")
      .check(terminal::whole(1, 1000))
      .type_name("N");
  command
      .add_option("--quality", options->quality,
                  "Error aimed at for local and scanline, in 8-bit levels, up to 64; 0.25 by default")
      .check(terminal::above_zero(64))
      .type_name("Q");
  command
      .add_option(
          "--show", options->show,
          "Paint what the engine decided instead of the picture: signatures, intervals, samples or cost")
      .check(terminal::one_of(names_of(all_shows)))
      .type_name("WHAT");
  command.add_option("--threads", options->threads, "Threads, up to 512; by default one for each processor")
      .check(terminal::whole(1, 512))
      .type_name("N");
  command
      .add_option(
          "--simd", options->simd,
          "Instruction set: auto (default), the widest that the processor has; baseline, avx2 or avx512. "
          "The picture is the same")
      .check(terminal::one_of({"auto", "baseline", "avx2", "avx512"}))
      .type_name("SET");
  command
      .add_option("--device", options->device,
                  "Address of the frame buffer: mem: (default), one inside this program; unix:PATH or "
                  "tcp:HOST:PORT, m508 serve; file:PATH or pipe: (standard output), which only take "
                  "commands: no PNG")
      .type_name("ADDR");
  command
      .add_option(
          "--timeout", options->timeout,
          "Seconds to wait each time for the device to connect, to take bytes or to answer; over a bad "
          "link beginning, verifying and reading back take ten times as long at most, each, with all "
          "repeats. 10 by default")
      .check(terminal::above_zero(86400))
      .type_name("S");
  command.add_option("--record", options->recording, "What is sent to the device, as a trace for m508")
      .type_name("T.m508");
  command.add_flag("--stats", options->statistics, "Print counts and times");
  command.add_flag("--json", options->json, "Print counts and times as one JSON object");
  command.footer("Example:\n  halftone render scenes/fig9a.toml -o fig9a.png --stats");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
