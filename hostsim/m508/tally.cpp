#include "tally.h"

#include <halftone/recording/walk.h>

namespace halftone::m508 {

namespace {

void add(std::map<std::string, Share>& shares, std::string_view name, std::uint64_t bytes) {
  Share& share = shares[std::string(name)];
  ++share.count;
  share.bytes += bytes;
}

void pass(device::Clock& clock, const protocol::Item& item) {
  clock.transfer(item.size);
  const auto* command = std::get_if<protocol::Message>(&item.content);
  if (command == nullptr) return;
  clock.execute(*command);
  if (command->opcode == protocol::Opcode::wait)
    clock.wait(command->operands[protocol::index_of(protocol::Opcode::wait, "fields")]);
}

} // namespace

Tally tally_of(const recording::Trace& trace, const std::vector<device::Bus>& buses) {
  Tally tally;
  tally.cut_off = !trace.cut_off.empty();
  tally.bytes = tally.fill = data_of(trace).size();
  for (const device::Bus& bus : buses) tally.clocks.push_back({bus, 0});
  for (recording::Walk walk(trace); const auto step = walk.next();) {
    const protocol::Item& item = step->item;
    tally.commands = step->number;
    tally.sessions = step->session;
    tally.fill -= item.size;
    for (device::Clock& clock : tally.clocks) pass(clock, item);
    if (step->is_restart) continue; // no client sent it
    if (const auto* command = std::get_if<protocol::Message>(&item.content)) {
      tally.pixels += device::pixels_of(*command);
      add(tally.opcodes, protocol::entry_of(command->opcode).name, item.size);
    } else {
      const auto fault = std::get<protocol::Rejection>(item.content).fault;
      ++tally.rejected;
      add(tally.errors, protocol::fault_table[static_cast<std::size_t>(fault)].name, item.size);
    }
  }
  return tally;
}

} // namespace halftone::m508
