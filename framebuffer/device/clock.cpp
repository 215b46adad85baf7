#include <halftone/device/clock.h>

#include <halftone/protocol/opcodes.h>

#include <limits>

namespace halftone::device {

namespace {

using protocol::index_of;
using protocol::Message;
using protocol::Opcode;

// A field is no whole number of picoseconds, but three are.
constexpr std::uint64_t three_fields = 50'000'000'000;

constexpr std::uint64_t end_of_time = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return b > end_of_time - a ? end_of_time : a + b; }

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > end_of_time / a ? end_of_time : a * b;
}

std::uint64_t fields_begun(std::uint64_t picoseconds) {
  return picoseconds / three_fields * 3 + picoseconds % three_fields * 3 / three_fields;
}

/// The first picosecond of a field.
std::uint64_t start_of(std::uint64_t field) {
  return field / 3 * three_fields + (field % 3 * three_fields + 2) / 3;
}

} // namespace

void Clock::transfer(std::uint64_t bytes) {
  picoseconds = sum(picoseconds, sum(product(bytes, bus.byte_picoseconds), bus.frame_picoseconds));
}

void Clock::execute(const Message& command) {
  const protocol::Cost& cost = protocol::entry_of(command.opcode).cost;
  picoseconds = sum(picoseconds, (cost.command + std::uint64_t{cost.pixel} * pixels_of(command)) * 1000);
}

void Clock::wait(std::uint32_t count) {
  const std::uint64_t field = fields_begun(picoseconds) + count;
  picoseconds = field > fields_begun(end_of_time) ? end_of_time : start_of(field);
}

std::uint32_t fields(const Clock& clock) {
  return static_cast<std::uint32_t>(fields_begun(clock.picoseconds));
}

std::uint32_t pixels_of(const Message& command) {
  const auto area = [&] { return command.operands[2] * command.operands[3]; };
  switch (command.opcode) {
  case Opcode::pixels:
    return static_cast<std::uint32_t>(command.data.size() / protocol::channels);
  case Opcode::runs: {
    std::uint32_t sum = 0;
    for (std::size_t run = 0; run < command.data.size(); run += 1 + protocol::channels)
      sum += command.data[run] + 1U;
    return sum;
  }
  case Opcode::repeat:
    return command.operands[index_of(Opcode::repeat, "count")];
  case Opcode::fill:
  case Opcode::copy:
  case Opcode::read:
  case Opcode::checksum:
  case Opcode::read_screen:
  case Opcode::overlay_fill:
    return area();
  default:
    return 0;
  }
}

} // namespace halftone::device
