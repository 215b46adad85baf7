#pragma once
// What can be wrong with what a decoder receives. The numbers are the error codes of the device's status.

#include <array>
#include <cstdint>
#include <string_view>

namespace halftone::protocol {

enum class Fault : std::uint8_t { none, damaged, unknown_opcode, wrong_length, out_of_limits };

struct FaultEntry {
  Fault fault;
  std::string_view name;
  std::string_view meaning;
};

/// In the order of the codes.
inline constexpr std::array fault_table{
    FaultEntry{Fault::none, "none", "nothing is wrong"},
    FaultEntry{Fault::damaged, "damaged",
               "bytes that are no frame were skipped: damaged or cut off on the way; the sequence number is "
               "that of the last good frame before them, 0 if there was none"},
    FaultEntry{Fault::unknown_opcode, "unknown opcode",
               "a whole frame with an opcode that is not in the table"},
    FaultEntry{Fault::wrong_length, "wrong length",
               "the payload is not as long as the command's operands are"},
    FaultEntry{Fault::out_of_limits, "out of limits",
               "an operand is outside its limits, or a rectangle reaches beyond the screen"},
};

} // namespace halftone::protocol
