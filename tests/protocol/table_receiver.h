#pragma once
// A receiver that knows nothing but the table of states in docs/protocol.md.

#include "naive_codec.h"

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace halftone::test {

/// A row of the table, word for word.
struct Transition {
  std::string state;
  std::string event;
  std::string next;
  std::string action;
  std::size_t taken = 0; ///< how often
};

std::vector<Transition> documented_transitions();

/// Throws std::logic_error where the table has no row, or an action that it does not know.
class TableReceiver {
public:
  explicit TableReceiver(std::vector<Transition>& table) : table_(table) {}

  /// The items that are reported when this byte comes, or at the end of the stream.
  std::vector<std::string> take(std::uint8_t byte);
  std::vector<std::string> end();

private:
  std::string event_of(std::uint8_t byte) const;
  void follow(const std::string& event);
  void act(const std::string& action);
  void take_all();
  void report_damage(std::size_t end);

  std::vector<Transition>& table_;
  std::string state_ = "idle";
  Bytes kept_;
  std::deque<std::uint8_t> coming_; ///< the one that comes first
  std::size_t position_ = 0;        ///< of the next byte that is taken, in the stream
  std::size_t damaged_ = 0;
  std::uint32_t last_sequence_ = 0;
  std::optional<std::uint8_t> byte_; ///< that has come; nothing at the end
  std::vector<std::string> reports_;
};

} // namespace halftone::test
