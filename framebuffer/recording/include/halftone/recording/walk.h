#pragma once
// Through a trace, one command after the other: the way in which every tool sees it.

#include <halftone/recording/trace.h>

#include <halftone/protocol/decoder.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace halftone::recording {

/// A command, a rejection or a restart; all are counted.
struct Step {
  std::uint64_t number = 0; ///< from 1
  std::uint64_t session =
      0; ///< from 1; bytes outside of a session belong to one without a peer; of a restart: the last
  std::uint64_t offset = 0; ///< of its first byte in data_of(trace)
  bool is_restart = false;  ///< of the device: the item is restart_item(), and no client's
  protocol::Item item;      ///< its data are valid until the next call of next(); its offset is the session's
};

/// Where the device does not do what the recorded one did.
struct Departure {
  std::uint64_t number = 0; ///< steps executed by then
  State recorded;
  std::uint32_t checksum = 0; ///< of the state that this device has come to
  /// Steps after which it had the recorded state for the last time; nothing where no state was recorded
  /// before.
  std::optional<std::uint64_t> agreed;

  bool operator==(const Departure&) const = default;
};

/// What becomes of the states in a trace: each takes the checksum of 1.6 MB to compare.
enum class States { passed_by, compared };

/// Whether more records may come: a walk then does not take the end of the trace for that of a session.
enum class Trail { ends, grows };

/// The walk's device executes what the recorded one did: each session from a new decoder, which is drained
/// where the session or the trace ends.
///
///   for (Walk walk(trace); const auto step = walk.next();) {
///     // walk.device() is as before the step
///     walk.execute();
///     // walk.device() is as after it
///   }
///
/// A copy that is made when a step has been executed, and before the next, goes on from there as the original
/// does.
class Walk {
public:
  /// The trace has to outlive the walk. States can be compared where it ends.
  explicit Walk(const Trace& trace, States states = States::passed_by, Trail trail = Trail::ends);

  /// The next step; executes the one before, if that was not done. Nothing at the end; where the trace grows,
  /// ask again when it has.
  std::optional<Step> next();

  /// Executes the step that next() returned last, once; queries, whose replies nobody would get, but take
  /// their time.
  void execute();

  const device::Device& device() const { return device_; }

  /// Records at the beginning of the trace that the walk needs no more.
  std::size_t passed() const;
  /// So many of them were taken out of the trace.
  void forget(std::size_t records);

  /// The first recorded state that the device did not have after as many steps as the recorded one, of those
  /// compared.
  const std::optional<Departure>& departure() const { return departure_; }

private:
  std::optional<protocol::Item> next_item();
  void enter(const Record& record);
  void begin_session();
  void end_session();
  void compare_due();
  void compare_late();
  void compare(const State& recorded);

  const Trace& trace_;
  Trail trail_;
  device::Device device_;
  protocol::Decoder decoder_{protocol::Direction::to_device};
  std::size_t record_ = 0;               ///< of the trace, not yet entered
  std::span<const std::uint8_t> unread_; ///< of the data that were entered last
  bool draining_ = false;                ///< the session has ended
  bool in_session_ = false;
  std::uint64_t session_ = 0;
  std::uint64_t begin_ = 0;   ///< of the session, in all data
  std::uint64_t entered_ = 0; ///< bytes of data
  std::uint64_t number_ = 0;
  bool is_restart_ = false;               ///< what is pending
  std::optional<protocol::Item> pending_; ///< found and not executed

  std::vector<State> states_;      ///< to be compared, in the order of the trace
  std::size_t compared_ = 0;       ///< of them
  std::size_t entered_states_ = 0; ///< of them, whose records have been passed
  std::uint64_t executed_ = 0;     ///< steps
  std::optional<std::uint64_t> agreed_;
  std::optional<Departure> departure_;
};

/// Walks through a trace to its end for the first recorded state that a device does not have.
std::optional<Departure> departure(const Trace& trace);

} // namespace halftone::recording
