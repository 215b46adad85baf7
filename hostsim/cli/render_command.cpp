// halftone render: scene file to rows, rows through the frame buffer, and the picture as it is read back from
// there.

#include "commands.h"
#include "limits.h"
#include "output_file.h"
#include "pfm.h"
#include "progress.h"
#include "render_report.h"

#include <halftone/driver/driver.h>
#include <halftone/link/link.h>
#include <halftone/png/png.h>
#include <halftone/render/render.h>
#include <halftone/scene/read.h>

#include <CLI/CLI.hpp>

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

struct Options {
  std::string scene;
  std::string picture; ///< empty: the scene's name with .png in the current folder
  std::string screen;  ///< empty: not asked for, as below
  std::string radiance;
  std::string mode{render::name(render::Mode::local)};
  std::optional<int> samples;
  int threads = 0;
  std::string device = "mem:";
  double timeout = 10; ///< seconds
  bool statistics = false;
  bool json = false;
};

std::vector<std::string> mode_names() {
  std::vector<std::string> names;
  for (const render::Mode mode : all_modes) names.emplace_back(render::name(mode));
  return names;
}

render::Mode mode_called(const std::string& name) {
  for (const render::Mode mode : all_modes)
    if (render::name(mode) == name) return mode;
  throw ArgumentError("--mode: unknown mode " + name);
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
  const auto place_of = [](const fs::path& file) {
    std::error_code none; // as at the end of a loop of links, where writing will fail
    return fs::weakly_canonical(fs::absolute(file, none), none);
  };
  std::vector<fs::path> taken{place_of(scene)};
  for (const fs::path& file : {outputs.picture, outputs.screen, outputs.radiance}) {
    if (file.empty()) continue;
    check_writable(file);
    const fs::path place = place_of(file);
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
  const scene::Scene scene = scene::read_scene(options.scene);
  const Outputs outputs = check_outputs(options);
  const render::Settings settings{
      .mode = mode_called(options.mode), .samples = options.samples, .threads = options.threads};
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
    const SignalShelter shelter;
    png::write(outputs.picture, picture, encoding);
    if (!outputs.screen.empty()) png::write(outputs.screen, screen, encoding);
    if (!outputs.radiance.empty()) write_whole(outputs.radiance, encode_pfm(width, height, radiance));
  }

  const RenderReport report{width, height, settings.mode, statistics, driver.seconds()};
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
      ->check(CLI::IsMember(mode_names()).description(""))
      ->type_name("MODE");
  app->add_option("--samples", options->samples,
                  "Samples a pixel along each side, up to 1000; by default 4 for full, 16 for reference")
      ->check(CLI::Range(1, 1000).description(""))
      ->type_name("N");
  app->add_option("--threads", options->threads, "Threads, up to 512; by default one for each processor")
      ->check(CLI::Range(1, 512).description(""))
      ->type_name("N");
  app->add_option("--device", options->device,
                  "Address of the frame buffer; mem: (default) is one inside this program")
      ->type_name("ADDR");
  app->add_option("--timeout", options->timeout, "Seconds to wait for an answer of the device; 10 by default")
      ->check(above_zero(86400))
      ->type_name("S");
  app->add_flag("--stats", options->statistics, "Print counts and times");
  app->add_flag("--json", options->json, "Print counts and times as one JSON object");
  app->footer("Example:\n  halftone render scenes/fig9a.toml -o fig9a.png --stats");
  return {app, [options] { return run(*options); }};
}

} // namespace halftone::cli
