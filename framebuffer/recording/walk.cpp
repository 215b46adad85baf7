#include <halftone/recording/walk.h>

#include <halftone/device/snapshot.h>

namespace halftone::recording {

Walk::Walk(const Trace& trace) : trace_(trace), device_(initial_device(trace.header)) {}

std::optional<Step> Walk::next() {
  execute();
  pending_ = next_item();
  if (!pending_) return std::nullopt;
  if (is_restart_) return Step{++number_, session_, entered_, true, *pending_};
  return Step{++number_, session_, begin_ + pending_->offset, false, *pending_};
}

void Walk::execute() {
  if (pending_) device_.execute(*pending_);
  pending_.reset();
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
    } else if (in_session_) {
      end_session();
    } else {
      return std::nullopt;
    }
  }
}

void Walk::enter(const Record& record) {
  if (const auto* data = std::get_if<Data>(&record)) {
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
    compare(std::get<State>(record));
  }
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

void Walk::compare(const State& recorded) {
  if (departure_) return;
  const std::uint32_t checksum = device::state_checksum(device_);
  if (recorded != State{number_, checksum}) departure_ = Departure{number_, recorded, checksum};
}

} // namespace halftone::recording
