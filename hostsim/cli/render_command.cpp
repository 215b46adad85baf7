// halftone render: scene file to rows, rows through the frame buffer, and the picture as it is read back from
// there.

#include "commands.h"
#include "drawing_options.h"
#include "output_options.h"
#include "progress.h"
#include "render_report.h"
#include <halftone/terminal/growing_file.h>
#include <halftone/terminal/output_file.h>

#include <halftone/device/device.h>
#include <halftone/driver/driver.h>
#include <halftone/link/link.h>
#include <halftone/link/recording_link.h>
#include <halftone/recording/write.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace halftone::cli {

namespace fs = std::filesystem;

namespace {

struct Options {
  DrawingOptions drawing;
  OutputOptions output; ///< without a picture: the scene's name with .png in the current folder
};

struct Outputs {
  PictureFiles pictures; ///< without a picture where the device cannot give it back
  fs::path commands;     ///< what a device that is a file is sent to
  fs::path recording;
};

/// What was asked for must be possible with a device that only takes.
void check_one_way(const Options& options, const link::Address& device) {
  const auto* file = std::get_if<link::FileAddress>(&device);
  const auto refuse = [&](const std::string& option) {
    throw ArgumentError(option + ": " + link::name(device) +
                        " only takes commands, and gives no picture back; the picture in them is read with: "
                        "m508 replay " +
                        (file != nullptr ? file->path : "FILE") + " -o OUT.png");
  };
  if (!options.output.picture.empty()) refuse("-o");
  if (!options.output.screen.empty()) refuse("--screen");
  if (file != nullptr) return;
  if (options.output.statistics) throw ArgumentError("--stats: standard output is for the commands");
  if (options.output.json) throw ArgumentError("--json: standard output is for the commands");
}

/// Finds what would fail after minutes of rendering: files that cannot be written, or that are each other or
/// the scene.
Outputs check_outputs(const Options& options, const link::Address& device) {
  const fs::path scene(options.drawing.scene);
  Outputs outputs{{{}, options.output.screen, options.output.radiance}, {}, options.output.recording};
  if (link::has_way_back(device))
    outputs.pictures.picture =
        options.output.picture.empty() ? fs::path(scene.stem()) += ".png" : fs::path(options.output.picture);
  if (const auto* file = std::get_if<link::FileAddress>(&device)) outputs.commands = file->path;
  terminal::check_outputs({{"-o", outputs.pictures.picture},
                           {"--screen", outputs.pictures.screen},
                           {"--float", outputs.pictures.radiance},
                           {"--device", outputs.commands},
                           {"--record", outputs.recording}},
                          {scene});
  return outputs;
}

ExitCode run(const Options& options) {
  const render::Settings settings = settings_of(options.drawing);
  const link::Address device = device_of(options.drawing);
  if (!link::has_way_back(device)) check_one_way(options, device);
  const scene::Scene scene = scene::read_scene(options.drawing.scene);
  const Outputs outputs = check_outputs(options, device);
  const int width = scene.image.width, height = scene.image.height;

  const auto timeout = timeout_of(options.drawing);
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

  Pictures pictures;
  render::Statistics statistics;
  {
    Progress progress(height);
    statistics = render::render(scene, settings, [&](const render::Row& row) {
      driver.send_row(row.y, row.rgb);
      if (!outputs.pictures.radiance.empty())
        pictures.radiance.insert(pictures.radiance.end(), row.radiance.begin(), row.radiance.end());
      progress.report(row.y + 1);
    });
  }
  driver.finish();

  if (!outputs.pictures.picture.empty()) pictures.picture = driver.read_picture();
  if (!outputs.pictures.screen.empty()) pictures.screen = driver.read_screen();
  if (recording_link != nullptr) recording_link->end("done");
  {
    const terminal::SignalShelter shelter;
    link->finish();
    write(outputs.pictures, scene.image, pictures);
  }
  if (!link->has_way_back())
    std::cerr << "halftone: sent to " << link::name(device) << ", which gives no picture back: no PNG\n";

  const RenderReport report{width, height, statistics, driver.seconds()};
  if (options.output.json)
    std::cout << as_json(report);
  else if (options.output.statistics)
    std::cout << for_people(report);
  return ExitCode::done;
}

} // namespace

Command add_render(Arguments program) {
  Arguments command = program.add_subcommand("render", "Render a scene through the frame buffer to a PNG");
  const auto options = std::make_shared<Options>();
  add_scene(command, options->drawing);
  add_output_options(command, options->output,
                     "The picture as read back from the device; by default the scene's name with .png in the "
                     "current folder");
  add_drawing_options(command, options->drawing, Devices::all);
  command.footer("Example:\n  halftone render scenes/fig9a.toml -o fig9a.png --stats");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
