#include <halftone/recording/walk.h>

#include <halftone/device/snapshot.h>

#include <algorithm>
#include <cassert>

namespace halftone::recording {

Walk::Walk(const Trace& trace, States states, Trail trail)
    : trace_(trace),
      trail_(trail),
      device_(initial_device(trace.header)) {
  if (states == States::passed_by) return;
  for (const Record& record : trace.records)
    if (const auto* state = std::get_if<State>(&record)) states_.push_back(*state);
  compare_due();
}

std::optional<Step> Walk::next() {
  execute();
  pending_ = next_item();
  if (!pending_) return std::nullopt;
  if (is_restart_) return Step{++number_, session_, entered_, true, *pending_};
  return Step{++number_, session_, begin_ + pending_->offset, false, *pending_};
}

void Walk::execute() {
  if (!pending_) return;
  device_.execute(*pending_);
  pending_.reset();
  ++executed_;
  compare_due();
}

std::optional<protocol::Item> Walk::next_item() {
  while (true) {
    if (auto item = draining_ ? decoder_.drain() : decoder_.next(unread_)) return item;
    draining_ = false;
    is_restart_ = !in_session_ && record_ < trace_.records.size() &&
                  std::holds_alternative<Restart>(trace_.records[record_]);
    if (is_restart_) {
      ++record_;
      return restart_item();
    }
    if (record_ < trace_.records.size()) {
      enter(trace_.records[record_++]);
    } else if (in_session_ && trail_ == Trail::ends) {
      end_session();
    } else {
      compare_late();
      return std::nullopt;
    }
  }
}

void Walk::enter(const Record& record) {
  if (const auto* data = std::get_if<Data>(&record)) {
    compare_late();
    if (!in_session_) begin_session();
    unread_ = data->bytes;
    entered_ += data->bytes.size();
  } else if (std::holds_alternative<SessionBegin>(record)) {
    if (in_session_) { // nobody said that the one before has ended
      end_session();
      --record_;
    } else {
      begin_session();
    }
  } else if (std::holds_alternative<SessionEnd>(record)) {
    end_session();
  } else if (std::holds_alternative<Restart>(record)) { // in a session, of which nobody said that it ended
    end_session();
    --record_;
  } else {
    ++entered_states_;
  }
}

std::size_t Walk::passed() const {
  // What is unread, or found and not executed, may still lie in the record that was entered last.
  return unread_.empty() && !pending_ ? record_ : record_ - 1;
}

void Walk::forget(std::size_t records) {
  assert(records <= passed());
  record_ -= records;
}

void Walk::begin_session() {
  decoder_ = protocol::Decoder(protocol::Direction::to_device);
  begin_ = entered_;
  ++session_;
  in_session_ = true;
}

void Walk::end_session() {
  draining_ = true;
  in_session_ = false;
}

/// A state's record comes behind the data of the steps that it counts, and often of more: a recorder writes
/// down what it receives before it executes it.
void Walk::compare_due() {
  while (compared_ < states_.size() && states_[compared_].commands == executed_)
    compare(states_[compared_++]);
}

/// A state whose steps are not all in the data before it is none that this device came to.
void Walk::compare_late() {
  while (compared_ < entered_states_ && compared_ < states_.size()) compare(states_[compared_++]);
}

void Walk::compare(const State& recorded) {
  if (departure_) return;
  const std::uint32_t checksum = device::state_checksum(device_);
  if (recorded == State{executed_, checksum})
    agreed_ = executed_;
  else
    departure_ = Departure{executed_, recorded, checksum, agreed_};
}

std::optional<Departure> departure(const Trace& trace) {
  const auto is_state = [](const Record& record) { return std::holds_alternative<State>(record); };
  if (std::ranges::none_of(trace.records, is_state)) return std::nullopt;
  Walk walk(trace, States::compared);
  while (walk.next()) continue;
  return walk.departure();
}

} // namespace halftone::recording
