// m508 who: which command painted a pixel.

#include "commands.h"

#include "input.h"
#include "stop.h"
#include "told.h"

#include <halftone/inspect/seen.h>
#include <halftone/inspect/who.h>
#include <halftone/recording/walk.h>
#include <halftone/terminal/limits.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace halftone::m508 {

namespace {

using inspect::Decider;
using inspect::Place;
using inspect::Seen;
using inspect::Writers;

constexpr std::size_t brief_history = 6; ///< the last writer among them

struct Options {
  std::string file;
  std::uint16_t x = 0;
  std::uint16_t y = 0;
  std::string plane = "screen";
  std::string until; ///< empty: to the end
  bool all = false;
  bool json = false;
};

struct Answer {
  std::optional<Seen> seen; ///< of the plane "screen"
  Place place;
  Writers writers;
};

std::string at(std::uint16_t x, std::uint16_t y) {
  return '(' + std::to_string(x) + ", " + std::to_string(y) + ')';
}

std::string text_of(const Place& place) {
  return std::string(inspect::name_of(place.plane)) + ' ' + at(place.x, place.y);
}

std::string color_text(const device::Pixel& color) { return inspect::text_of(device::Plane::image_0, color); }

/// Why the screen shows something else than what is in memory there; empty if it does not.
std::string reason(const Options& options, const Seen& seen) {
  const std::string color = color_text(seen.color);
  switch (seen.decider) {
  case Decider::blank:
    return "the screen is blank: 0 0 0 is seen";
  case Decider::border:
    return "the border covers it: " + color + " is seen";
  case Decider::cursor:
    return "the cursor covers it: " + color + " is seen";
  case Decider::overlay:
    return "the overlay covers it: " + color + " is seen; ask who wrote that with --plane overlay " +
           std::to_string(options.x) + ' ' + std::to_string(options.y);
  case Decider::image:
    break;
  }
  if (seen.memory == seen.color) return {};
  std::string text;
  if (seen.memory != seen.masked) text = "the read mask leaves " + color_text(seen.masked);
  if (seen.masked != seen.color)
    text += std::string(text.empty() ? "" : ", of which ") + "the look-up tables make " + color;
  return text;
}

std::string for_people(const Options& options, const Answer& answer) {
  std::ostringstream text;
  const Writers& writers = answer.writers;
  const std::string when = " after " + of_them(writers.commands, "command");
  if (answer.seen)
    text << "at screen " << at(options.x, options.y) << when << " lies " << text_of(answer.place) << ": "
         << inspect::text_of(answer.place.plane, writers.value) << '\n';
  else
    text << text_of(answer.place) << when << ": " << inspect::text_of(answer.place.plane, writers.value)
         << '\n';
  if (answer.seen)
    if (const std::string why = reason(options, *answer.seen); !why.empty()) text << "but " << why << '\n';

  const auto value = [&](const device::Pixel& pixel) { return inspect::text_of(answer.place.plane, pixel); };
  const auto change = [&](const inspect::Write& write) {
    if (write.masked_out) return value(write.before) + " stays: the write mask is 0 0 0";
    return value(write.before) + " -> " + value(write.after);
  };
  if (!writers.last) {
    text << "no command has written it\n";
  } else {
    text << "last written by " << place_of(writers.last->command) << "\n  " << writers.last->command.text
         << "\n  " << change(*writers.last) << '\n';
  }

  std::ostringstream others;
  std::uint64_t told = writers.last ? 1 : 0;
  for (const inspect::Write& write : writers.newest) {
    if (writers.last && write.command.number == writers.last->command.number) continue;
    others << "  " << place_of(write.command) << "\n    " << write.command.text << "\n    " << change(write)
           << '\n';
    ++told;
  }
  if (!others.str().empty()) text << "other commands that addressed it, newest first\n" << others.str();
  if (told < writers.writes) text << "and " << writers.writes - told << " more before (--all)\n";
  return text.str();
}

nlohmann::ordered_json json_of(const Place& place, const inspect::Write& write) {
  nlohmann::ordered_json object = m508::json_of(write.command);
  object["before"] = m508::json_of(place.plane, write.before);
  object["after"] = m508::json_of(place.plane, write.after);
  object["masked_out"] = write.masked_out;
  return object;
}

std::string as_json(const Answer& answer) {
  using Json = nlohmann::ordered_json;
  const Writers& writers = answer.writers;
  Json history = Json::array();
  for (const inspect::Write& write : writers.newest) history.push_back(json_of(answer.place, write));
  Json screen;
  if (answer.seen)
    screen = {{"decided_by", inspect::name_of(answer.seen->decider)},
              {"color", m508::json_of(device::Plane::image_0, answer.seen->color)},
              {"after_read_mask", m508::json_of(device::Plane::image_0, answer.seen->masked)},
              {"after_lut", m508::json_of(device::Plane::image_0, answer.seen->through)}};
  const Json object = {
      {"plane", inspect::name_of(answer.place.plane)},
      {"x", answer.place.x},
      {"y", answer.place.y},
      {"commands", writers.commands},
      {"screen", screen},
      {"start", m508::json_of(answer.place.plane, writers.start)},
      {"value", m508::json_of(answer.place.plane, writers.value)},
      {"writes", writers.writes},
      {"last", writers.last ? json_of(answer.place, *writers.last) : Json()},
      {"history", history},
  };
  return object.dump(2) + "\n";
}

/// The number of the last command that is looked at.
std::uint64_t last_number(const Options& options, const recording::Trace& trace) {
  if (options.until.empty()) return inspect::to_the_end;
  const Stop stop = parse_stop(options.until);
  recording::Walk walk(trace);
  if (is_reached(stop, walk.device())) return 0;
  std::uint64_t number = 0;
  while (const auto step = walk.next()) {
    walk.execute();
    number = step->number;
    if (is_reached(stop, *step, walk.device())) return number;
  }
  throw ArgumentError("--until " + options.until + ": the recording ends before, after command " +
                      std::to_string(number));
}

Answer ask(const Options& options, const recording::Trace& trace) {
  const std::uint64_t until = last_number(options, trace);
  Answer answer;
  if (options.plane == "screen") {
    answer.seen = inspect::seen_at(inspect::device_after(trace, until), options.x, options.y);
    answer.place = answer.seen->source;
  } else {
    const device::Plane plane = options.plane == "image0"   ? device::Plane::image_0
                                : options.plane == "image1" ? device::Plane::image_1
                                                            : device::Plane::overlay;
    answer.place = {plane, options.x, options.y};
  }
  const std::size_t at_most = options.all ? std::numeric_limits<std::size_t>::max() : brief_history;
  answer.writers = inspect::who(trace, answer.place, at_most, until);
  return answer;
}

ExitCode run(const Options& options) {
  const recording::Trace trace = read_trace(options.file);
  const Answer answer = ask(options, trace);
  std::cout << (options.json ? as_json(answer) : for_people(options, answer));
  return answer.writers.last ? ExitCode::done : ExitCode::no;
}

} // namespace

Command add_who(Arguments program) {
  Arguments command =
      program.add_subcommand("who", "Tell which commands wrote a pixel, and what they made of it");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording or raw stream of commands, - for standard input")
      .required()
      .type_name("");
  command.add_option("X", options->x, "Column, 0 to 511")
      .required()
      .check(terminal::whole(0, 511))
      .type_name("");
  command.add_option("Y", options->y, "Row, 0 to 511")
      .required()
      .check(terminal::whole(0, 511))
      .type_name("");
  command
      .add_option("--plane", options->plane,
                  "screen (the default: the pixel of the image that lies there), image0, image1 or overlay")
      .check(terminal::one_of({"screen", "image0", "image1", "overlay"}))
      .type_name("PLANE");
  command
      .add_option(
          "--until", options->until,
          "Look no farther than command N, the mark of that name, or the beginning of field N of 1/60 s")
      .type_name("N|mark:NAME|frame:N");
  command.add_flag("--all", options->all, "Tell all commands that wrote it, however many");
  command.add_flag("--json", options->json, "Print it as one JSON object");
  command.footer("Exit code 1 if no command wrote it.\n\nExample:\n  m508 who session.m508 256 200");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
