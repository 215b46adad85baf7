#include <halftone/watch/watcher.h>

#include "probe.h"

#include <halftone/watch/panel.h>

#include <halftone/device/screen.h>
#include <halftone/file/write.h>
#include <halftone/png/png.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <span>
#include <sstream>
#include <utility>
#include <variant>

namespace halftone::watch {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// How long a key may wait for a look, and how often the screen is shown while it changes all the time.
constexpr auto look_interval = 8ms;
constexpr auto show_interval = 10ms;

constexpr auto message_time = 3s;

constexpr std::size_t row_size = std::size_t{protocol::screen_width} * protocol::channels;

/// The rows from the first to the last that differ; none: a count of 0. All where there was nothing before.
display::Rows difference(const device::Bytes& before, const device::Bytes& after) {
  if (before.empty()) return {0, display::screen_height};
  const auto differs = [&](int y) {
    const auto begin = static_cast<std::ptrdiff_t>(row_size) * y;
    return !std::equal(before.begin() + begin, before.begin() + begin + row_size, after.begin() + begin);
  };
  int first = 0, end = display::screen_height;
  while (first < end && !differs(first)) ++first;
  while (end > first && !differs(end - 1)) --end;
  return {first, end - first};
}

/// The first name of the kind that is free in the current folder.
std::filesystem::path free_name(std::uint64_t& number) {
  while (true) {
    std::ostringstream name;
    name << "screen-" << std::setfill('0') << std::setw(4) << ++number << ".png";
    if (!std::filesystem::exists(name.str())) return name.str();
  }
}

} // namespace

Watcher::Watcher(const Displays& displays, Player& player, Tape& tape, const std::vector<device::Bus>& buses,
                 Subject subject)
    : displays_(displays),
      player_(player),
      tape_(tape),
      buses_(buses),
      subject_(std::move(subject)),
      inquiry_(std::make_unique<Inquiry>()) {}

Watcher::~Watcher() = default;

void Watcher::set_pace(const std::optional<std::size_t>& bus) {
  pace_ = bus;
  player_.play(bus ? std::optional(buses_[*bus]) : std::nullopt, Clock::now());
  has_changed_ = true;
}

void Watcher::stand_at(std::uint64_t commands) {
  player_.seek(commands);
  has_changed_ = true;
}

bool Watcher::look() {
  const bool is_asking = probe_ && inquiry_->is_under_way();
  if (is_asking) tape_.wake();
  player_.extend(tape_.take(Clock::now() + look_interval));
  has_changed_ = player_.advance(Clock::now()) || has_changed_;
  if (!pace_ && !player_.is_paused() && player_.can_follow() && player_.position() == player_.length())
    follow();

  // Of these the last one, or where all together lead to: each costs a walk through the stream.
  std::optional<display::Probe> probe;
  for (const auto& display : displays_) {
    for (const display::Event& event : display->poll()) {
      if (std::holds_alternative<display::Quit>(event)) return false;
      if (const auto* asked = std::get_if<display::Probe>(&event)) {
        probe = *asked;
      } else if (const auto* scrub = std::get_if<display::Scrub>(&event)) {
        sought_ = place_of(*scrub);
      } else {
        go_to_sought();
        obey(event);
      }
    }
  }
  go_to_sought();
  if (probe) {
    probe_ = probe;
    has_changed_ = true;
  }
  if (has_changed_ && Clock::now() - shown_at_ >= show_interval)
    show();
  else if (is_asking)
    probed_ = probed();
  say();
  return true;
}

void Watcher::obey(const display::Event& event) {
  if (std::holds_alternative<display::EndProbe>(event))
    probe_.reset();
  else if (std::holds_alternative<display::Pause>(event))
    toggle_pause();
  else if (const auto* pace = std::get_if<display::Pace>(&event))
    change_pace(pace->steps);
  else if (const auto* pulled = std::get_if<display::Drag>(&event))
    drag(*pulled);
  else if (std::holds_alternative<display::Follow>(event))
    follow();
  else if (std::holds_alternative<display::Screenshot>(event))
    take_screenshot();
  else
    command(event);
  has_changed_ = true;
}

void Watcher::go_to_sought() {
  if (sought_) stand_at(*sought_);
  sought_.reset();
}

/// To the device that people look at: what they do has to be seen.
void Watcher::command(const display::Event& event) {
  const device::Bytes commands = commands_for(event, player_.device().registers);
  if (commands.empty()) return;
  if (!player_.is_following()) return player_.interpose(commands);
  subject_.send(commands);
  // The next key has to find what this one has done.
  player_.extend(tape_.take(Clock::now() + look_interval));
  player_.advance(Clock::now());
}

/// As a whole since it began, or what is less than a pixel of the image would be lost at each pull.
void Watcher::drag(const display::Drag& drag) {
  if (drag.begins) {
    held_ = drag;
    pulled_ = {};
    return;
  }
  const int zoom = player_.device().registers.zoom;
  const display::Pan wanted{(held_.x - drag.x) >> zoom, (held_.y - drag.y) >> zoom};
  const display::Pan pan{wanted.right - pulled_.right, wanted.down - pulled_.down};
  if (pan == display::Pan{}) return;
  pulled_ = wanted;
  command(pan);
}

void Watcher::toggle_pause() {
  if (!player_.is_paused()) return player_.pause();
  set_pace(pace_);
}

void Watcher::change_pace(int steps) {
  // In the order of speed: the buses, and then no bus at all.
  const auto most = static_cast<int>(buses_.size());
  const int now = pace_ ? static_cast<int>(*pace_) : most;
  const int then = std::clamp(now + steps, 0, most);
  set_pace(then == most ? std::nullopt : std::optional(static_cast<std::size_t>(then)));
}

std::uint64_t Watcher::place_of(const display::Scrub& scrub) const {
  const auto length = static_cast<double>(player_.length()),
             position = static_cast<double>(sought_.value_or(player_.position()));
  double place = position + scrub.amount;
  if (scrub.by == display::Scrub::By::share) place = position + scrub.amount * length;
  if (scrub.by == display::Scrub::By::place) place = scrub.amount * length;
  return static_cast<std::uint64_t>(std::lround(std::clamp(place, 0.0, length)));
}

/// What was done to the device while somebody looked elsewhere is done to the real one, too: it looks the
/// same.
void Watcher::follow() {
  const device::Bytes commands = player_.interposed();
  pace_.reset();
  player_.follow();
  if (player_.is_following() && !commands.empty()) subject_.send(commands);
  has_changed_ = true;
}

void Watcher::take_screenshot() {
  const std::filesystem::path file = free_name(screenshots_);
  message_ends_ = Clock::now() + message_time;
  try {
    png::write(file, {protocol::screen_width, protocol::screen_height, device::screen(player_.device())},
               png::Encoding::srgb);
    message_ = "kept as " + file.string();
  } catch (const file::WriteError& error) {
    message_ = error.what();
  }
}

void Watcher::show() {
  device::Bytes screen = device::screen(player_.device());
  const display::Rows changed = difference(screen_, screen);
  screen_ = std::move(screen);
  has_changed_ = false;
  if (changed.count > 0) {
    shown_at_ = Clock::now();
    for (const auto& display : displays_) display->show({screen_, changed});
  }
  probed_ = probed();
}

void Watcher::say() {
  display::Words words;
  words.title = subject_.title();
  words.status = status(Clock::now());
  words.place = player_.length() == 0
                    ? 1
                    : static_cast<double>(player_.position()) / static_cast<double>(player_.length());
  if (probe_) words.probed = probed_;
  if (words == words_) return;
  words_ = words;
  for (const auto& display : displays_) display->say(words_);
}

std::string Watcher::status(Time now) const {
  std::ostringstream text;
  const bool is_elsewhere = !player_.is_following() && player_.position() != player_.length();
  if (is_elsewhere || player_.is_paused() || pace_)
    text << "command " << player_.position() << " of " << player_.length();
  if (player_.is_paused()) text << ", paused";
  if (pace_) text << (text.str().empty() ? "" : ", ") << "at the pace of " << buses_[*pace_].name;
  if (now < message_ends_) text << (text.str().empty() ? "" : ", ") << message_;
  return text.str();
}

std::vector<std::string> Watcher::probed() {
  if (!probe_) return {};
  return inquiry_->describe(player_,
                            static_cast<std::uint16_t>(std::clamp(probe_->x, 0, display::screen_width - 1)),
                            static_cast<std::uint16_t>(std::clamp(probe_->y, 0, display::screen_height - 1)));
}

} // namespace halftone::watch
