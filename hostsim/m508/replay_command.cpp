// m508 replay: plays a recording to a device, and shows what it comes to.

#include "commands.h"
#include "input.h"
#include "picture.h"
#include "shown.h"
#include "stop.h"
#include "told.h"

#include <halftone/bus/buses.h>
#include <halftone/device/snapshot.h>
#include <halftone/recording/walk.h>
#include <halftone/serve/stop_signals.h>
#include <halftone/terminal/limits.h>
#include <halftone/terminal/output_file.h>
#include <halftone/watch/displays.h>
#include <halftone/watch/player.h>

#include <charconv>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace halftone::m508 {

namespace {

struct Options {
  std::string file;
  std::string until; ///< empty: to the end
  std::uint64_t each = 0;
  std::string output; ///< empty: no picture
  std::string view = "shown";
  bool pace = false;
  std::string bus; ///< empty: the recorded one
  std::string buses;
  std::vector<std::string> displays;
};

/// The parser has checked that the name is one of these.
View view_called(const std::string& name) {
  return name == "raw" ? View::raw : name == "lut" ? View::lut : View::shown;
}

/// screen.png, 120 → screen-00000120.png: names in the order of the commands.
std::filesystem::path numbered(const std::filesystem::path& file, std::uint64_t number) {
  std::ostringstream name;
  name << file.stem().string() << '-' << std::setfill('0') << std::setw(8) << number
       << file.extension().string();
  return std::filesystem::path(file).replace_filename(name.str());
}

/// The picture in the end and, of those that --each may write, the ones that have the name of an input.
std::vector<terminal::Output> outputs_of(const Options& options) {
  std::vector<terminal::Output> outputs{{"-o", options.output}};
  if (options.each == 0) return outputs;
  for (const std::string& input : {options.file, options.buses}) {
    const std::string name = path_of(input).stem().string();
    const std::string digits = name.substr(name.rfind('-') + 1);
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = error == std::errc() && end == digits.data() + digits.size();
    if (is_number && number != 0 && number % options.each == 0)
      outputs.push_back({"--each", numbered(options.output, number)});
  }
  return outputs;
}

/// Keeps a replay from running ahead of the device's clock.
class Pace {
public:
  explicit Pace(const device::Clock& clock) : began_(clock.picoseconds) {}

  void wait_for(const device::Clock& clock) const {
    const std::chrono::nanoseconds passed((clock.picoseconds - began_) / 1000);
    std::this_thread::sleep_until(start_ + passed);
  }

private:
  std::uint64_t began_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

class Replay {
public:
  using Time = std::chrono::steady_clock::time_point;

  /// keeps_pace: here, and not where displays follow.
  Replay(const Options& options, const recording::Trace& trace, bool keeps_pace)
      : options_(options),
        walk_(trace, recording::States::compared) {
    if (!options.until.empty()) stop_ = parse_stop(options.until);
    if (keeps_pace) pace_.emplace(walk_.device().clock);
    is_reached_ = stop_ && is_reached(*stop_, walk_.device());
  }

  /// Plays on until then; whether it is over, at the stop or at the end of the recording.
  bool play(Time until) {
    while (!is_reached_) {
      const auto step = walk_.next();
      if (!step) return true;
      execute(*step);
      is_reached_ = stop_ && is_reached(*stop_, *step, walk_.device());
      if (std::chrono::steady_clock::now() >= until) break;
    }
    return is_reached_;
  }

  /// When it is over: the picture, and what there is to say.
  ExitCode finish() {
    if (stop_ && !is_reached_)
      throw ArgumentError("--until " + options_.until + ": the recording ends before, after command " +
                          std::to_string(played_));
    if (!options_.output.empty()) write(options_.output);
    return report();
  }

  /// What there is to say of what was played; what it comes to there.
  ExitCode report() const {
    std::cout << "commands   " << played_ << '\n'
              << "rejected   " << rejected_ << '\n'
              << "fields     " << fields(walk_.device().clock) << '\n'
              << "seconds    " << static_cast<double>(walk_.device().clock.picoseconds) * 1e-12 << '\n'
              << "state      " << in_hexadecimal(device::state_checksum(walk_.device())) << '\n'
              << std::flush;
    if (rejected_ != 0)
      std::cerr << "m508: " << options_.file << ": " << rejected_ << " of " << played_
                << " commands were rejected, the first of them " << first_rejected_ << ": "
                << protocol::fault_table[static_cast<std::size_t>(first_fault_)].name << '\n';
    return verdict();
  }

  std::uint64_t played() const { return played_; }

private:
  void execute(const recording::Step& step) {
    walk_.execute();
    played_ = step.number;
    if (const auto* rejection = std::get_if<protocol::Rejection>(&step.item.content)) {
      if (rejected_++ == 0) {
        first_rejected_ = step.number;
        first_fault_ = rejection->fault;
      }
    }
    if (pace_) pace_->wait_for(walk_.device().clock);
    if (options_.each != 0 && played_ % options_.each == 0) write(numbered(options_.output, played_));
  }

  void write(const std::filesystem::path& file) const {
    const terminal::SignalShelter shelter;
    png::write(file, picture_of(walk_.device(), view_called(options_.view)), png::Encoding::srgb);
  }

  ExitCode verdict() const {
    const auto& departure = walk_.departure();
    if (!departure) return ExitCode::done;
    std::cerr << "m508: " << text_of(options_.file, *departure) << '\n';
    return ExitCode::no;
  }

  const Options& options_;
  recording::Walk walk_;
  std::optional<Stop> stop_;
  bool is_reached_ = false; ///< the stop
  std::optional<Pace> pace_;
  std::uint64_t played_ = 0;
  std::uint64_t rejected_ = 0;
  std::uint64_t first_rejected_ = 0;
  protocol::Fault first_fault_ = protocol::Fault::none;
};

using namespace std::chrono_literals;

// Between two looks at what people and signals ask for.
constexpr auto slice = 8ms;

[[noreturn]] void throw_stopped(const Options& options, const Replay& replay) {
  throw OutputError(options.file + ": stopped by a signal after command " + std::to_string(replay.played()) +
                    ", before the replay was over");
}

/// Plays beside displays, which answer meanwhile and stay until somebody there has had enough. The exit code
/// where the replay is finished by then.
std::optional<ExitCode> show(const Options& options, watch::Player& player, Replay& replay,
                             const serve::StopSignals& stop, const watch::Displays& displays) {
  const Start start = options.pace            ? Start::at_pace
                      : options.until.empty() ? Start::at_end
                                              : Start::elsewhere;
  ShownRecording shown(options.file, player, start, displays);
  // At a pace people see no more than was played here: where that ends, be it at a mark, they stop, too.
  const bool stops = !options.until.empty(), holds = stops && start == Start::at_pace;
  if (holds) shown.hold_at(replay.played());
  std::optional<ExitCode> code;
  while (shown.look(!code)) {
    if (stop.have_come()) {
      if (!code) throw_stopped(options, replay);
      break;
    }
    if (code) continue;
    const bool is_over = replay.play(std::chrono::steady_clock::now() + slice);
    if (holds) shown.hold_at(replay.played());
    if (!is_over) continue;
    code = replay.finish();
    if (stops) shown.stand_at(replay.played());
  }
  return code;
}

/// After the displays, which were closed before the replay was over: the rest is played where there are files
/// to be written. What there is to say is of no use to those who have left.
ExitCode leave(const Options& options, Replay& replay, const serve::StopSignals& stop) {
  if (options.output.empty()) {
    std::cerr << "m508: " << options.file << ": closed after command " << replay.played()
              << ", before the replay was over\n";
    return replay.report();
  }
  std::cerr << "m508: " << options.file << ": playing the rest, for " << options.output
            << (options.each != 0 ? " and --each" : "") << '\n';
  while (!replay.play(std::chrono::steady_clock::now() + slice))
    if (stop.have_come()) throw_stopped(options, replay);
  return replay.finish();
}

ExitCode replay_shown(const Options& options, recording::Trace trace,
                      const std::vector<display::Choice>& choices) {
  watch::Player player(std::move(trace), recording::Trail::ends);
  Replay replay(options, player.trace(), false);
  std::optional<ExitCode> code;
  std::exception_ptr failure;
  const serve::StopSignals stop;
  {
    const watch::Displays displays = watch::open_displays(choices);
    std::cout << watch::addresses_of(choices, displays) << std::flush;
    try {
      code = show(options, player, replay, stop, displays);
    } catch (const display::DisplayError&) {
      failure = std::current_exception();
    }
  }
  if (!code) code = leave(options, replay, stop);
  if (failure) std::rethrow_exception(failure);
  return *code;
}

ExitCode run(const Options& options) {
  if (options.each != 0 && options.output.empty()) throw ArgumentError("--each: needs -o OUT.png");
  if (!options.buses.empty() && options.bus.empty()) throw ArgumentError("--buses: needs --bus NAME");
  const std::vector<display::Choice> choices = watch::parse_displays(options.displays);
  check_files(outputs_of(options), {options.file, options.buses});
  std::optional<device::Bus> bus;
  if (!options.bus.empty()) bus = bus::find_bus(read_buses(options.buses), options.bus);
  recording::Trace trace = read_trace(options.file);
  if (bus) trace.header.bus = *bus;
  if (!choices.empty()) return replay_shown(options, std::move(trace), choices);
  Replay replay(options, trace, options.pace);
  replay.play(Replay::Time::max());
  return replay.finish();
}

} // namespace

Command add_replay(Arguments program) {
  Arguments command = program.add_subcommand("replay", "Play a recording, and show what the device comes to");
  const auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Recording (.m508) or raw stream, - for standard input")
      .required()
      .type_name("");
  command
      .add_option("--until", options->until,
                  "Stop after command N, at the mark of that name, or when field N of 1/60 s has begun")
      .type_name("N|mark:NAME|frame:N");
  command.add_option("--each", options->each, "A picture after each K commands besides, OUT-00000120.png")
      .check(terminal::whole(1, ~std::uint64_t{0}))
      .type_name("K");
  command.add_option("-o,--output", options->output, "The picture in the end; none if left out")
      .type_name("OUT.png");
  command.add_option("--as", options->view, "The memory, the memory after the look-up tables, or the screen")
      .check(terminal::one_of({"raw", "lut", "shown"}))
      .type_name("raw|lut|shown");
  command.add_flag("--pace", options->pace, "Take the time that the device and its bus would have taken");
  command.add_option("--bus", options->bus, "The bus, by its name in the table; the recorded one if left out")
      .type_name("NAME");
  command.add_option("--buses", options->buses, "A table of buses instead of the built-in one")
      .type_name("FILE.toml");
  command
      .add_option("--display", options->displays,
                  "Where people see it, forward and back: window, vnc or web, several times for several; "
                  "none (default). "
                  "Stands at the end, or at --until; with --pace it is played from the beginning to there")
      .type_name("NAME[:WHERE]");
  command.footer("Exits with 1 where the device does not come to the states that were recorded.\n\n"
                 "Example:\n  m508 replay session.m508 --until mark:frame -o screen.png");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::m508
