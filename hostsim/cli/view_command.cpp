// halftone view: a scene in a window while it is drawn, through the frame buffer as ever.

#include "commands.h"
#include "drawing_options.h"
#include "output_options.h"
#include "painting.h"
#include "render_report.h"

#include <halftone/bus/buses.h>
#include <halftone/device/device.h>
#include <halftone/link/link.h>
#include <halftone/link/recording_link.h>
#include <halftone/link/shared_link.h>
#include <halftone/recording/write.h>
#include <halftone/scene/read.h>
#include <halftone/serve/stop_signals.h>
#include <halftone/terminal/growing_file.h>
#include <halftone/terminal/output_file.h>
#include <halftone/watch/displays.h>
#include <halftone/watch/player.h>
#include <halftone/watch/tape.h>
#include <halftone/watch/watcher.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace halftone::cli {

namespace {

struct Options {
  DrawingOptions drawing;
  std::vector<std::string> displays; ///< empty: a window
  std::string bus;                   ///< empty: as it comes
  OutputOptions output;
};

/// For a device to take what keys have asked of it, when the window is closed.
constexpr std::chrono::milliseconds patience(500);

std::optional<std::size_t> pace_of(const Options& options, const std::vector<device::Bus>& buses) {
  if (options.bus.empty()) return std::nullopt;
  return static_cast<std::size_t>(&bus::find_bus(buses, options.bus) - buses.data());
}

/// Keeps what was asked for of a picture that is done. What there is to say of it.
std::string keep(const OutputOptions& options, const Painted& painted) {
  const scene::Image& image = painted.scene.image;
  Pictures pictures;
  if (!options.picture.empty()) pictures.picture = painted.driver.read_picture();
  // With what people have made of it by keys.
  if (!options.screen.empty()) pictures.screen = painted.driver.read_shown();
  if (!options.radiance.empty()) pictures.radiance = painted.radiance;
  write({options.picture, options.screen, options.radiance}, image, pictures);
  const RenderReport report{image.width, image.height, painted.statistics,
                            painted.driver.seconds() - painted.seconds_before};
  if (options.json) return as_json(report);
  return options.statistics ? for_people(report) : "";
}

/// How the session ended, for its recording.
std::string ending_of(const std::exception_ptr& failure) {
  if (!failure) return "the window was closed";
  try {
    std::rethrow_exception(failure);
  } catch (const display::DisplayError&) {
    return "the window has gone";
  } catch (const std::exception& error) {
    return error.what();
  }
}

ExitCode run(const Options& options) {
  const render::Settings settings = settings_of(options.drawing);
  const link::Address device = device_of(options.drawing);
  if (!link::has_way_back(device))
    throw ArgumentError("--device: " + link::name(device) +
                        " only takes commands; draw to it with halftone render, and see it with m508 replay");
  const std::vector<display::Choice> choices =
      watch::parse_displays(options.displays.empty() ? std::vector<std::string>{"window"} : options.displays);
  if (choices.empty())
    throw ArgumentError("--display: with none there is nothing to view; see halftone render");
  const std::vector<device::Bus> buses = bus::built_in();
  const std::optional<std::size_t> pace = pace_of(options, buses);
  scene::read_scene(options.drawing.scene); // what is wrong with it is told before a window is opened
  const OutputOptions& output = options.output;
  terminal::check_outputs({{"-o", output.picture},
                           {"--screen", output.screen},
                           {"--float", output.radiance},
                           {"--record", output.recording}},
                          {options.drawing.scene});

  const serve::StopSignals stop;
  const watch::Displays displays = watch::open_displays(choices);
  (output.json ? std::cerr : std::cout) << watch::addresses_of(choices, displays) << std::flush;
  watch::Tape tape;
  std::optional<terminal::GrowingFile> file;
  if (!output.recording.empty()) file.emplace(output.recording);
  const auto sink = [&](std::span<const std::uint8_t> bytes) {
    if (file) file->append(bytes);
    tape.append(bytes);
  };
  // The driver begins with a reset, so that it does not matter what the device was before.
  recording::Writer recording(sink, device::Device());
  auto recorded = std::make_unique<link::RecordingLink>(link::open(device, timeout_of(options.drawing)),
                                                        recording, "halftone view");
  link::RecordingLink& session = *recorded;
  link::SharedLink link(std::move(recorded));
  std::string report; // of the last picture that was done
  bool is_kept = false;
  std::exception_ptr failure; // what is recorded is whole for all that
  const auto attempt = [&](const auto& step) {
    try {
      step();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  };
  attempt([&] {
    Painting painting(options.drawing.scene, settings, link, timeout_of(options.drawing),
                      [&](const Painted& painted) {
                        report = keep(output, painted);
                        is_kept = true;
                        if (!output.json) std::cout << report << std::flush;
                      });
    watch::Player player({}, recording::Trail::grows, watch::past_for(displays));
    watch::Watcher watcher(
        displays, player, tape, buses,
        {[&] { return painting.title(); }, [&](const device::Bytes& commands) { link.post(commands); }});
    watcher.set_pace(pace);
    while (!stop.have_come() && watcher.look()) {
      painting.look();
      link.check();
    }
    painting.finish();
  });
  attempt([&] { link.settle(patience); });
  attempt([&] {
    session.end(ending_of(failure));
    link.finish();
  });
  if (output.json) std::cout << report;
  if (failure) std::rethrow_exception(failure);
  if (!is_kept)
    for (const std::string& asked : {output.picture, output.screen, output.radiance})
      if (!asked.empty())
        std::cerr << "halftone: closed before a picture was done: " << asked << " was not written\n";
  return ExitCode::done;
}

} // namespace

Command add_view(Arguments program) {
  Arguments command =
      program.add_subcommand("view", "See a scene while it is drawn, and again when its file changes");
  const auto options = std::make_shared<Options>();
  add_scene(command, options->drawing);
  command
      .add_option("--display", options->displays,
                  "Where: window (default), vnc or web; may be given several times")
      .type_name("NAME[:WHERE]");
  command
      .add_option("--bus", options->bus,
                  "Show it at the pace at which this bus would have brought it, as rs232 or gpib; keys s and "
                  "f change "
                  "it")
      .type_name("NAME");
  add_output_options(
      command, options->output,
      "The picture as read back from the device, like --screen and --float whenever it is done");
  add_drawing_options(command, options->drawing, Devices::with_way_back);
  command.footer("Key h in the window tells what the others do.\n\n"
                 "Example:\n  halftone view scenes/fig9b.toml --bus dma16");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
