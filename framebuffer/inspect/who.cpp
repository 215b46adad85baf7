#include <halftone/inspect/who.h>

#include <halftone/recording/walk.h>

#include <algorithm>
#include <deque>

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

Writers who(const recording::Trace& trace, const Place& place, std::size_t at_most, std::uint64_t until) {
  recording::Walk walk(trace);
  Writers writers;
  writers.start = value_at(walk.device(), place);
  Sections sections;
  std::deque<Write> newest;
  while (writers.commands < until) {
    const auto step = walk.next();
    if (!step) break;
    ++writers.commands;
    sections.follow(*step);
    const protocol::Message* message = message_of(*step);
    if (message == nullptr || !addresses(walk.device().registers, *message, place)) continue;
    Write write{sections.refer_to(*step),
                value_at(walk.device(), place),
                {},
                is_masked_out(walk.device().registers, *message)};
    walk.execute();
    write.after = value_at(walk.device(), place);
    ++writers.writes;
    if (!write.masked_out) writers.last = write;
    newest.push_front(std::move(write));
    if (newest.size() > at_most) newest.pop_back();
  }
  walk.execute();
  writers.value = value_at(walk.device(), place);
  writers.newest.assign(newest.begin(), newest.end());
  return writers;
}

} // namespace halftone::inspect
