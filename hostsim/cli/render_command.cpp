// halftone render: scene file to rows, rows through the frame buffer, and the picture as it is read back from
// there.

#include "commands.h"
#include "pfm.h"
#include "progress.h"
#include "render_report.h"
#include <halftone/terminal/limits.h>
#include <halftone/terminal/output_file.h>

#include <halftone/driver/driver.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace halftone::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::array all_modes = {render::Mode::local, render::Mode::scanline, render::Mode::full,
                                  render::Mode::reference};
constexpr std::array all_shows = {render::Show::intervals, render::Show::samples, render::Show::cost};

struct Options {
  std::string scene;
  std::string picture; ///< empty: the scene's name with .png in the current folder
  std::string screen;  ///< empty: not asked for, as below
  std::string radiance;
  std::string mode{render::name(render::Mode::local)};
  std::string show; ///< empty: the picture itself
  std::optional<int> samples;
  std::optional<int> lines;
  int threads = 0;
  std::string device = "mem:";
  double timeout = 10; ///< seconds
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

/// Throws ArgumentError for an option that the mode has no use for.
render::Settings settings_of(const Options& options) {
  render::Settings settings{.mode = called(all_modes, options.mode),
                            .samples = options.samples,
                            .threads = options.threads,
                            .lines = options.lines};
  if (!options.show.empty()) settings.show = called(all_shows, options.show);
  const bool scanned = settings.mode == render::Mode::local || settings.mode == render::Mode::scanline;
  const auto refuse = [&](const char* option, const char* modes) {
    throw ArgumentError(std::string(option) + ": mode " + options.mode + " has no use for it; it is for " +
                        modes);
  };
  if (scanned && settings.samples) refuse("--samples", "modes full and reference");
  if (!scanned && settings.lines) refuse("--lines", "modes local and scanline");
  if (!scanned && settings.show) refuse("--show", "modes local and scanline");
  return settings;
}

struct Outputs {
  fs::path picture;
  fs::path screen;
  fs::path radiance;
};

/// Finds what would fail after minutes of rendering: files that cannot be written, or that are each other or
/// the scene.
Outputs check_outputs(const Options& options) {
  const fs::path scene(options.scene);
  const Outputs outputs{options.picture.empty() ? fs::path(scene.stem()) += ".png"
                                                : fs::path(options.picture),
                        options.screen, options.radiance};
  std::vector<fs::path> taken{terminal::place_of(scene)};
  for (const fs::path& file : {outputs.picture, outputs.screen, outputs.radiance}) {
    if (file.empty()) continue;
    terminal::check_writable(file);
    const fs::path place = terminal::place_of(file);
    for (const fs::path& other : taken)
      if (place == other)
        throw ArgumentError(file.string() + ": would be written over by another file of this render");
    taken.push_back(place);
  }
  return outputs;
}

std::unique_ptr<link::Link> open_link(const std::string& address) {
  try {
    return link::open(address);
  } catch (const std::invalid_argument& error) {
    throw ArgumentError("--device: " + std::string(error.what()));
  }
}

ExitCode run(const Options& options) {
  const render::Settings settings = settings_of(options);
  const scene::Scene scene = scene::read_scene(options.scene);
  const Outputs outputs = check_outputs(options);
  const int width = scene.image.width, height = scene.image.height;

  const std::unique_ptr<link::Link> link = open_link(options.device);
  driver::Driver driver(
      *link, std::chrono::ceil<std::chrono::milliseconds>(std::chrono::duration<double>(options.timeout)));
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
  const png::Picture picture{width, height, driver.read_picture()};
  const png::Picture screen{512, 512,
                            outputs.screen.empty() ? std::vector<std::uint8_t>() : driver.read_screen()};
  {
    const terminal::SignalShelter shelter;
    png::write(outputs.picture, picture, encoding);
    if (!outputs.screen.empty()) png::write(outputs.screen, screen, encoding);
    if (!outputs.radiance.empty())
      terminal::write_whole(outputs.radiance, encode_pfm(width, height, radiance));
  }

  const RenderReport report{width, height, statistics, driver.seconds()};
  if (options.json)
    std::cout << as_json(report);
  else if (options.statistics)
    std::cout << for_people(report);
  return ExitCode::done;
}

} // namespace

Command add_render(CLI::App& program) {
  CLI::App* app = program.add_subcommand("render", "Render a scene through the frame buffer to a PNG");
  const auto options = std::make_shared<Options>();
  app->add_option("SCENE", options->scene, "Scene file (.toml)")->required()->type_name("");
  app->add_option(
         "-o", options->picture,
         "The picture as read back from the device; by default the scene's name with .png in the current "
         "folder")
      ->type_name("OUT.png");
  app->add_option("--screen", options->screen, "The whole 512 x 512 screen as shown")->type_name("OUT.png");
  app->add_option("--float", options->radiance,
                  "Radiance before exposure and rounding, as a portable float map")
      ->type_name("OUT.pfm");
  app->add_option(
         "--mode", options->mode,
         "local: scanlines, and rays where the scene needs them (default); scanline: no rays, glass opaque; "
         "full: rays everywhere; reference: brute force")
      ->check(CLI::IsMember(names_of(all_modes)).description(""))
      ->type_name("MODE");
  app->add_option("--samples", options->samples,
                  "Samples a pixel along each side for full and reference, up to 1000; 4 and 16 by default")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N");
  app->add_option("--lines", options->lines,
                  "Virtual scanlines a row for local and scanline, up to 1000; 8 by default")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N");
  app->add_option("--show", options->show,
                  "Paint what the engine decided instead of the picture: intervals, samples or cost")
      ->check(CLI::IsMember(names_of(all_shows)).description(""))
      ->type_name("WHAT");
  app->add_option("--threads", options->threads, "Threads, up to 512; by default one for each processor")
      ->check(CLI::Range(1, 512).description(""))
      ->type_name("N");
  app->add_option("--device", options->device,
                  "Address of the frame buffer; mem: (default) is one inside this program")
      ->type_name("ADDR");
  app->add_option("--timeout", options->timeout, "Seconds to wait for an answer of the device; 10 by default")
      ->check(terminal::above_zero(86400))
      ->type_name("S");
  app->add_flag("--stats", options->statistics, "Print counts and times");
  app->add_flag("--json", options->json, "Print counts and times as one JSON object");
  app->footer("Example:\n  halftone render scenes/fig9a.toml -o fig9a.png --stats");
  return {app, [options] { return run(*options); }};
}

} // namespace halftone::cli
