#pragma once
// A recorded stream, shown at any place of it: while it grows, at its own pace or at that of a bus of 1985,
// forward and back.

#include <halftone/device/clock.h>
#include <halftone/device/device.h>
#include <halftone/recording/trace.h>
#include <halftone/recording/walk.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace halftone::watch {

/// Whether somebody may want to go back.
enum class Past { kept, forgotten };

/// Two devices go through the stream: one is always at its end, and leaves snapshots behind; the other is
/// where somebody looks, and is not there while that is the end. Going back starts from the snapshot before.
///
/// Takes the memory of the stream, and of 48 snapshots at most; where the past is forgotten, of no snapshot,
/// and of what is between the two.
class Player {
public:
  using Time = std::chrono::steady_clock::time_point;

  /// A stream that grows is followed, one that does not is shown from its beginning. Plays nothing yet.
  /// Only what grows can be forgotten: then seek() and trace() are of no use, and play() is for a player that
  /// follows.
  Player(recording::Trace trace, recording::Trail trail, Past past = Past::kept);
  Player(const Player&) = delete; // what goes through the trace refers to it
  Player& operator=(const Player&) = delete;

  /// The stream has gone on.
  void extend(std::vector<recording::Record> records);

  /// Plays what is due by now, and what is there of the stream, some milliseconds of work at most. Whether
  /// the screen may have changed.
  bool advance(Time now);

  /// The device that is looked at, with what was done to it from outside the stream.
  const device::Device& device() const { return is_following() ? head_.device() : shown_; }

  /// Commands from outside the stream to the device that is looked at, which is not the one at the end. They
  /// hold for as long as somebody looks at another place than the end, and wherever that is.
  void interpose(std::span<const std::uint8_t> commands);

  /// All that was interposed since the stream was followed last.
  const device::Bytes& interposed() const { return interposed_; }

  /// To the end, and on with it.
  void follow();

  /// To the place after so many commands, or the end; stops there.
  void seek(std::uint64_t commands);

  void pause();
  /// Plays on from here. Without a bus: on to the end.
  void play(const std::optional<device::Bus>& bus, Time now);

  /// What is played waits there, after so many commands; not what somebody has taken further.
  void hold_at(const std::optional<std::uint64_t>& commands) { hold_ = commands; }

  bool is_following() const { return !view_; }
  bool can_follow() const { return view_ && trail_ == recording::Trail::grows; }
  bool is_paused() const { return is_paused_; }

  std::uint64_t position() const { return is_following() ? length_ : position_; } ///< commands executed
  std::uint64_t length() const { return length_; } ///< commands in all, of what advance() has played

  const recording::Trace& trace() const { return trace_; }

private:
  bool play_head(Time until);
  bool play_view(Time now);
  void leave_snapshot();
  void forget();
  void look_from(std::uint64_t commands);
  void update_shown();

  recording::Trace trace_;
  recording::Trail trail_;
  Past past_;
  recording::Walk head_;
  std::uint64_t length_ = 0;
  std::map<std::uint64_t, recording::Walk>
      snapshots_;         ///< by commands executed; 0 is among them where the past is kept
  std::uint64_t spacing_; ///< commands between snapshots

  std::optional<recording::Walk> view_; ///< nothing: the head is looked at
  std::uint64_t position_ = 0;          ///< of the view
  bool is_under_way_ = false;           ///< the step after it: found, and not executed before its time
  device::Device shown_;                ///< that of the view, and then what was interposed
  device::Bytes interposed_;
  bool is_paused_ = false;
  std::optional<std::uint64_t> hold_; ///< commands
  std::optional<device::Bus> bus_;    ///< that the view is played at; nothing: as fast as can be
  device::Clock played_;              ///< by that bus, since `since_`
  Time since_;
};

} // namespace halftone::watch
