#pragma once
// Between displays and a player: shows on all of them what the player plays, and does what people at them ask
// for.

#include <halftone/watch/player.h>
#include <halftone/watch/tape.h>

#include <halftone/device/clock.h>
#include <halftone/display/display.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halftone::watch {

using Displays = std::vector<std::unique_ptr<display::Display>>;

/// What is watched.
struct Subject {
  std::function<std::string()> title; ///< asked at every look
  /// Sends commands to the device at the end of the stream; none where the stream is all there is.
  std::function<void(const device::Bytes& commands)> send;
};

class Inquiry;

class Watcher {
public:
  /// Buses from the slowest to the fastest. Everything named must outlive the watcher.
  Watcher(const Displays& displays, Player& player, Tape& tape, const std::vector<device::Bus>& buses,
          Subject subject);
  ~Watcher();

  /// Plays at the bus of this place in the table, or as fast as the stream comes.
  void set_pace(const std::optional<std::size_t>& bus);

  /// Stops after so many commands, or at the end.
  void stand_at(std::uint64_t commands);

  /// Waits a little for the stream, shows what has become of it, and does what people ask for. False once one
  /// of them has asked for the end. Throws display::DisplayError; and png's and file's errors where a
  /// screenshot cannot be written are words on the displays.
  bool look();

private:
  using Time = Player::Time;

  void obey(const display::Event& event);
  void command(const display::Event& event);
  void drag(const display::Drag& drag);
  std::uint64_t place_of(const display::Scrub& scrub) const;
  void go_to_sought();
  void change_pace(int steps);
  void toggle_pause();
  void follow();
  void take_screenshot();
  void show();
  void say();
  std::string status(Time now) const;
  std::vector<std::string> probed();

  const Displays& displays_;
  Player& player_;
  Tape& tape_;
  const std::vector<device::Bus>& buses_;
  Subject subject_;

  std::optional<std::size_t> pace_; ///< a bus; nothing: as fast as the stream comes
  bool has_changed_ = true;         ///< the screen, perhaps
  device::Bytes screen_;            ///< as shown; empty: none yet
  Time shown_at_;
  display::Words words_;                ///< as said
  std::optional<std::uint64_t> sought_; ///< asked for by scrubs, and not gone to yet
  std::optional<display::Probe> probe_;
  std::unique_ptr<Inquiry> inquiry_;
  std::vector<std::string> probed_; ///< about it
  display::Drag held_;              ///< where the image was taken hold of
  display::Pan pulled_;             ///< so far
  std::string message_;             ///< that something was done, said for a while
  Time message_ends_;
  std::uint64_t screenshots_ = 0;
};

} // namespace halftone::watch
