// m508 stats: what a recording is made of, and how long it would take on each bus.

#include "commands.h"
#include "input.h"
#include "tally.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace halftone::m508 {

namespace {

struct Options {
  std::string file;
  std::string buses;
  bool json = false;
};

double seconds(const device::Clock& clock) { return static_cast<double>(clock.picoseconds) * 1e-12; }

std::string for_people(const Tally& tally) {
  std::ostringstream text;
  const auto line = [&](const std::string& name, const auto& value) -> std::ostream& {
    return text << std::left << std::setw(18) << name << std::right << std::setw(12) << value;
  };
  line("commands", tally.commands) << '\n';
  line("rejected", tally.rejected) << '\n';
  line("sessions", tally.sessions) << '\n';
  line("bytes", tally.bytes) << '\n';
  line("fill bytes", tally.fill) << '\n';
  line("pixels", tally.pixels) << "\n\n";
  for (const auto& [name, share] : tally.opcodes)
    line(name, share.count) << std::setw(14) << share.bytes << " bytes\n";
  for (const auto& [name, share] : tally.errors)
    line("! " + name, share.count) << std::setw(14) << share.bytes << " bytes\n";
  text << '\n';
  for (const device::Clock& clock : tally.clocks) line(clock.bus.name, seconds(clock)) << " s\n";
  return text.str();
}

nlohmann::ordered_json as_json(const std::map<std::string, Share>& shares) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [name, share] : shares)
    list.push_back({{"name", name}, {"count", share.count}, {"bytes", share.bytes}});
  return list;
}

std::string as_json(const Tally& tally) {
  nlohmann::ordered_json buses = nlohmann::ordered_json::array();
  for (const device::Clock& clock : tally.clocks)
    buses.push_back({{"name", clock.bus.name}, {"seconds", seconds(clock)}});
  const nlohmann::ordered_json object = {
      {"commands", tally.commands},
      {"rejected", tally.rejected},
      {"sessions", tally.sessions},
      {"bytes", tally.bytes},
      {"fill", tally.fill},
      {"pixels", tally.pixels},
      {"cut_off", tally.cut_off},
      {"opcodes", as_json(tally.opcodes)},
      {"errors", as_json(tally.errors)},
      {"buses", buses},
  };
  return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

ExitCode run(const Options& options) {
  check_files({}, {options.file, options.buses});
  const std::vector<device::Bus> buses = read_buses(options.buses);
  const Tally tally = tally_of(read_trace(options.file), buses);
  std::cout << (options.json ? as_json(tally) : for_people(tally));
  return ExitCode::done;
}

} // namespace

Command add_stats(Arguments program) {
  Arguments command =
      program.add_subcommand("stats", "Count what a recording is made of, and its time on each bus");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording (.m508) or raw stream, - for standard input")
      .required()
      .type_name("");
  command.add_option("--buses", options->buses, "A table of buses instead of the built-in one")
      .type_name("FILE.toml");
  command.add_flag("--json", options->json, "Print the numbers as one JSON object (docs/json.md)");
  command.footer("Example:\n  m508 stats session.m508");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
