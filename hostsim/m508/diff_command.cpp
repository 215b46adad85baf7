// m508 diff: where two recordings part.

#include "commands.h"

#include "input.h"
#include "told.h"

#include <halftone/inspect/diff.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace halftone::m508 {

namespace {

using inspect::Difference;
using inspect::Parting;
using inspect::Reference;
using Part = Difference::Part;

struct Options {
  std::string a;
  std::string b;
  bool ignore_clock = false;
  bool json = false;
};

std::string text_of(const Difference& difference) {
  const std::string values = "A " + difference.a + ", B " + difference.b;
  std::ostringstream text;
  switch (difference.part) {
  case Part::pixels: {
    const device::Rectangle& r = difference.bounds;
    text << "pixel (" << difference.x << ", " << difference.y << ") of " << difference.name << ": " << values;
    if (difference.count > 1)
      text << "; it is the first of " << difference.count << " pixels that differ, within " << r.width
           << " x " << r.height << " at (" << r.x << ", " << r.y << ')';
    break;
  }
  case Part::lut:
    text << "entry " << difference.x << " of the look-up table of " << difference.name << ": " << values;
    if (difference.count > 1) text << "; it is the first of " << difference.count << " entries that differ";
    break;
  case Part::cursor_pattern:
    text << "byte " << difference.x << " of the cursor's pattern: " << values;
    break;
  case Part::setting:
    text << "register " << difference.name << ": " << values;
    break;
  case Part::clock:
    text << "clock, in picoseconds: " << values << " (--ignore-clock leaves it out)";
    break;
  }
  return text.str();
}

std::string side(const std::string& name, const std::string& file, const std::optional<Reference>& command,
                 std::uint64_t step) {
  const std::string what = command     ? place_of(*command) + "\n     " + command->text
                           : step == 0 ? "the beginning"
                                       : "its end";
  return "  " + name + "  " + file + ": " + what + '\n';
}

std::string for_people(const Options& options, const std::optional<Parting>& parting) {
  if (!parting) return "the states do not differ after any command\n";
  std::string text = "the states differ for the first time after\n";
  text += side("A", options.a, parting->a, parting->step);
  text += side("B", options.b, parting->b, parting->step);
  for (const Difference& difference : parting->differences) text += text_of(difference) + '\n';
  return text;
}

std::string as_json(const std::optional<Parting>& parting) {
  using Json = nlohmann::ordered_json;
  Json object = {{"differ", parting.has_value()},
                 {"step", Json()},
                 {"a", Json()},
                 {"b", Json()},
                 {"differences", Json::array()}};
  if (parting) {
    object["step"] = parting->step;
    if (parting->a) object["a"] = json_of(*parting->a);
    if (parting->b) object["b"] = json_of(*parting->b);
    constexpr std::array names{"pixels", "lut", "cursor_pattern", "register", "clock"};
    for (const Difference& d : parting->differences) {
      Json told = {{"kind", names.at(static_cast<std::size_t>(d.part))},
                   {"name", d.name},
                   {"a", d.a},
                   {"b", d.b},
                   {"count", d.count}};
      if (d.part == Part::pixels) {
        told["x"] = d.x;
        told["y"] = d.y;
        told["bounds"] = json_of(d.bounds);
      }
      if (d.part == Part::lut || d.part == Part::cursor_pattern) told["index"] = d.x;
      object["differences"].push_back(told);
    }
  }
  return object.dump(2) + "\n";
}

/// What a recording that does not come to its own states is compared by is not what was recorded.
bool replays(const std::string& file, const recording::Trace& trace) {
  const auto departure = recording::departure(trace);
  if (departure) std::cerr << "m508: " << m508::text_of(file, *departure) << '\n';
  return !departure;
}

ExitCode run(const Options& options) {
  check_files({}, {options.a, options.b});
  const recording::Trace a = read_trace(options.a), b = read_trace(options.b);
  const std::optional<Parting> parting = inspect::diff(a, b, {options.ignore_clock});
  std::cout << (options.json ? as_json(parting) : for_people(options, parting));
  const bool a_replays = replays(options.a, a), b_replays = replays(options.b, b);
  return parting || !a_replays || !b_replays ? ExitCode::no : ExitCode::done;
}

} // namespace

Command add_diff(Arguments program) {
  Arguments command =
      program.add_subcommand("diff", "Find the first command after which two recordings differ");
  const auto options = std::make_shared<Options>();
  command.add_option("A", options->a, "Recording or raw stream of commands, - for standard input")
      .required()
      .type_name("");
  command.add_option("B", options->b, "Another").required().type_name("");
  command.add_flag("--ignore-clock", options->ignore_clock,
                   "Leave out the virtual time, and commands that do nothing but wait");
  command.add_flag("--json", options->json, "Print it as one JSON object");
  command.footer(
      "Commands that change something are executed side by side; queries and marks are left out.\n"
      "Exit code 1 if the recordings differ, or if one does not come to the states recorded in it.\n\n"
      "Example:\n  m508 diff yesterday.m508 today.m508 --ignore-clock");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
