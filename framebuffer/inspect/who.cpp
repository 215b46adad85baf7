#include <halftone/inspect/who.h>

#include <halftone/recording/walk.h>

#include <algorithm>
#include <utility>

namespace halftone::inspect {

namespace {

bool addresses(const device::Registers& registers, const protocol::Message& message, const Place& place) {
  return std::ranges::any_of(device::addressed(registers, message), [&](const device::Region& region) {
    return region.plane == place.plane && holds(region.area, place.x, place.y);
  });
}

} // namespace

device::Device device_after(const recording::Trace& trace, std::uint64_t until) {
  recording::Walk walk(trace);
  for (std::uint64_t done = 0; done < until && walk.next(); ++done) walk.execute();
  return walk.device();
}

Search::Search(const recording::Trace& trace, const Place& place, std::size_t at_most)
    : walk_(trace),
      place_(place),
      at_most_(at_most) {
  found_.start = value_at(walk_.device(), place);
}

bool Search::go_on(std::uint64_t until, Time deadline) {
  while (found_.commands < until) {
    const auto step = walk_.next();
    if (!step) return true;
    ++found_.commands;
    look_at(*step);
    walk_.execute();
    if (std::chrono::steady_clock::now() >= deadline) break;
  }
  return found_.commands >= until;
}

void Search::look_at(const recording::Step& step) {
  sections_.follow(step);
  const protocol::Message* message = message_of(step);
  if (message == nullptr || !addresses(walk_.device().registers, *message, place_)) return;
  Write write{sections_.refer_to(step),
              value_at(walk_.device(), place_),
              {},
              is_masked_out(walk_.device().registers, *message)};
  walk_.execute();
  write.after = value_at(walk_.device(), place_);
  ++found_.writes;
  if (!write.masked_out) found_.last = write;
  newest_.push_front(std::move(write));
  if (newest_.size() > at_most_) newest_.pop_back();
}

Writers Search::writers() const {
  Writers writers = found_;
  writers.value = value_at(walk_.device(), place_);
  writers.newest.assign(newest_.begin(), newest_.end());
  return writers;
}

Writers who(const recording::Trace& trace, const Place& place, std::size_t at_most, std::uint64_t until) {
  Search search(trace, place, at_most);
  search.go_on(until);
  return search.writers();
}

} // namespace halftone::inspect
