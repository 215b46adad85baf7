// m508 serve: the device as a process.

#include "commands.h"
#include "input.h"
#include "shown.h"

#include <halftone/bus/buses.h>
#include <halftone/terminal/growing_file.h>
#include <halftone/terminal/limits.h>
#include <halftone/terminal/output_file.h>

#include <halftone/device/screen.h>
#include <halftone/link/faults.h>
#include <halftone/png/png.h>
#include <halftone/recording/write.h>
#include <halftone/serve/server.h>
#include <halftone/serve/stop_signals.h>
#include <halftone/watch/displays.h>

#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace halftone::m508 {

namespace {

struct Options {
  std::string listen = "tcp:127.0.0.1:8508";
  std::string picture;   ///< empty: none
  std::string recording; ///< empty: none
  std::string bus;       ///< empty: unlimited
  std::string buses;
  std::optional<std::uint64_t> fault_seed;
  bool once = false;
  std::vector<std::string> displays;
};

link::Address address_of(const Options& options) {
  try {
    return link::parse_address(options.listen);
  } catch (const std::invalid_argument& error) {
    throw ArgumentError("--listen: " + std::string(error.what()));
  }
}

std::unique_ptr<serve::Listener> listen(const link::Address& address) {
  try {
    return std::make_unique<serve::Listener>(address);
  } catch (const std::invalid_argument& error) {
    throw ArgumentError("--listen: " + std::string(error.what()));
  }
}

ExitCode run(const Options& options) {
  const std::vector<display::Choice> choices = watch::parse_displays(options.displays);
  if (!options.buses.empty() && options.bus.empty()) throw ArgumentError("--buses: needs --bus NAME");
  check_files({{"-o", options.picture}, {"--record", options.recording}}, {options.buses});
  device::Device device;
  if (!options.bus.empty()) device.clock.bus = bus::find_bus(read_buses(options.buses), options.bus);

  // Before anybody can know that the server is there: a signal from then on ends it with its files written.
  const serve::StopSignals stop;
  std::exception_ptr failure;
  {
    const watch::Displays displays = watch::open_displays(choices);
    watch::Tape tape;
    const std::unique_ptr<serve::Listener> listener = listen(address_of(options));
    std::optional<terminal::GrowingFile> file;
    std::optional<recording::Writer> recording;
    if (!options.recording.empty()) file.emplace(options.recording);
    if (file || !displays.empty()) {
      const auto sink = [&](std::span<const std::uint8_t> bytes) {
        if (file) file->append(bytes);
        if (!displays.empty()) tape.append(bytes);
      };
      recording.emplace(sink, device);
    }
    if (options.fault_seed)
      std::cerr << "m508: spoils what passes; first client: "
                << link::describe(link::faults_of(*options.fault_seed)) << '\n';
    try {
      std::cout << "listening on " << link::name(listener->address()) << '\n'
                << watch::addresses_of(choices, displays) << std::flush;
      if (!std::cout) throw OutputError("standard output cannot be written: nobody learns the address");
      const serve::Settings settings{options.once, options.fault_seed};
      if (displays.empty())
        serve::serve(*listener, device, settings, recording ? &*recording : nullptr, stop.descriptor());
      else
        serve_shown(*listener, device, settings, *recording, stop, displays, tape);
    } catch (
        const std::runtime_error&) { // such as a full disk under the recording: the picture is still good
      failure = std::current_exception();
    }
  }
  if (!options.picture.empty())
    png::write(options.picture, {protocol::screen_width, protocol::screen_height, device::screen(device)},
               png::Encoding::srgb);
  if (failure) std::rethrow_exception(failure);
  return ExitCode::done;
}

} // namespace

Command add_serve(Arguments program) {
  Arguments command = program.add_subcommand("serve", "Be a frame buffer that drivers can connect to");
  const auto options = std::make_shared<Options>();
  command
      .add_option("--listen", options->listen,
                  "Where: unix:PATH or tcp:HOST:PORT, port 0 for any that is free; by default "
                  "tcp:127.0.0.1:8508. What it is is printed as \"listening on ADDRESS\"")
      .type_name("ADDRESS");
  command.add_option("-o", options->picture, "The screen as shown in the end").type_name("OUT.png");
  command.add_option("--record", options->recording, "Everything that clients send, as a trace")
      .type_name("T.m508");
  command.add_option("--bus", options->bus, "The bus that its clock counts with; unlimited if left out")
      .type_name("NAME");
  command.add_option("--buses", options->buses, "A table of buses instead of the built-in one")
      .type_name("FILE");
  command
      .add_option("--fault", options->fault_seed,
                  "Spoil what passes: flip, drop, truncate, delay, close, device restart, by this seed for "
                  "the first client, the next seed for the next client")
      .check(terminal::whole(0, ~std::uint64_t{0}))
      .type_name("SEED");
  command.add_flag("--once", options->once, "End after the first client");
  command
      .add_option(
          "--display", options->displays,
          "Where people see the screen: window, vnc or web, several times for several; none (default)")
      .type_name("NAME[:WHERE]");
  command.footer("SIGINT and SIGTERM end it, with its files written.\n\n"
                 "Example:\n  m508 serve --display window --record session.m508");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
