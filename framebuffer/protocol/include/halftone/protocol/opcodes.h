#pragma once
// The opcode table: the single source of the commands and replies for encoder, decoder and docs/protocol.md.
// A new command is a new row here, and what the device does about it.
//
// The set is a reconstruction (docs/protocol.md says from what). The costs are assumptions about a device of
// 1985: 10 us to interpret a command; a memory cycle of 400 ns for a pixel that is addressed, an eighth of it
// where memory is filled; one field of 1/60 s for a clear.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

namespace halftone::protocol {

inline constexpr std::uint8_t protocol_version = 1;
inline constexpr std::uint8_t reconstructed_profile = 0; ///< which command set; leaves room for the real one
inline constexpr std::uint16_t screen_width = 512;       ///< pixels
inline constexpr std::uint16_t screen_height = 512;      ///< rows
inline constexpr std::size_t channels = 3;               ///< bytes of a pixel: red, green, blue

/// Bytes of payload that a frame can carry. Bounds the memory of a decoder, and how much of a stream it may
/// hold back when a damaged length promises more than comes.
inline constexpr std::size_t payload_limit = 4096;

enum class Opcode : std::uint8_t {
  identify = 0x01,
  reset = 0x02,
  status = 0x03,
  window = 0x10,
  pixels = 0x11,
  clear = 0x12,
  fill = 0x13,
  read = 0x20,
  checksum = 0x21,
  // Replies: the number of the command that they answer, with the highest bit set.
  identity = 0x81,
  state = 0x83,
  row = 0xA0,
  sum = 0xA1,
};

enum class Direction { to_device, to_host };

/// Integers are unsigned and big-endian. Pixels and text reach to the end of the payload.
enum class OperandType { u8, u16, u32, pixels, text };

struct Operand {
  std::string_view name;
  OperandType type;
  std::uint32_t least; ///< smallest value; for pixels and text, smallest count of pixels or characters
  std::uint32_t most;  ///< largest value or count
  std::string_view meaning;
  int origin = -1; ///< if not negative: the operand there plus this one must not exceed most, either
};

/// Time that the device is busy, without the bus: nanoseconds, and nanoseconds for each pixel of the
/// command's rectangle or data.
struct Cost {
  std::uint32_t command = 0;
  std::uint32_t pixel = 0;
};

struct OpcodeEntry {
  Opcode opcode;
  std::string_view name;
  Direction direction;
  std::span<const Operand> operands; ///< in the order of the payload
  std::optional<Opcode> answer;      ///< the reply to it; commands that have one are called queries
  Cost cost;
  std::string_view meaning;
};

namespace layout {

inline constexpr std::uint32_t u8_most = 0xFF;
inline constexpr std::uint32_t u32_most = 0xFFFFFFFF;
inline constexpr std::uint32_t pixels_most = payload_limit / channels;

inline constexpr Operand x{"x", OperandType::u16, 0, screen_width - 1, "left column, 0 at the left"};
inline constexpr Operand y{"y", OperandType::u16, 0, screen_height - 1, "top row, 0 at the top"};
inline constexpr Operand width{"width", OperandType::u16, 1, screen_width, "columns", 0};
inline constexpr Operand height{"height", OperandType::u16, 1, screen_height, "rows", 1};

inline constexpr std::array rectangle{x, y, width, height};
inline constexpr std::array pixels{
    Operand{"pixels", OperandType::pixels, 1, pixels_most, "red, green, blue of each, a byte each"}};
inline constexpr std::array fill{x,
                                 y,
                                 width,
                                 height,
                                 Operand{"red", OperandType::u8, 0, u8_most, "red of every pixel"},
                                 Operand{"green", OperandType::u8, 0, u8_most, "green of every pixel"},
                                 Operand{"blue", OperandType::u8, 0, u8_most, "blue of every pixel"}};
inline constexpr std::array identity{
    Operand{"profile", OperandType::u8, 0, u8_most, "command set: 0 is this reconstruction"},
    Operand{"version", OperandType::u8, 0, u8_most, "version of the protocol"},
    Operand{"width", OperandType::u16, 1, 0xFFFF, "columns of the screen"},
    Operand{"height", OperandType::u16, 1, 0xFFFF, "rows of the screen"},
    Operand{"name", OperandType::text, 1, 64, "the device's name"}};
inline constexpr std::array state{
    Operand{"error", OperandType::u8, 0, u8_most, "first error since the reset, 0 if there was none"},
    Operand{"error_sequence", OperandType::u32, 0, u32_most, "sequence number of the command in error"},
    Operand{"errors", OperandType::u32, 0, u32_most, "errors since the reset"},
    Operand{"commands", OperandType::u32, 0, u32_most, "commands executed since the reset, without queries"},
    Operand{"skipped", OperandType::u32, 0, u32_most, "damaged bytes skipped since the reset"}};
inline constexpr std::array row{x, y,
                                Operand{"pixels", OperandType::pixels, 1, screen_width, "from the left"}};
inline constexpr std::array sum{
    Operand{"checksum", OperandType::u32, 0, u32_most, "CRC-32 of the rectangle's bytes in row order"}};

} // namespace layout

/// In ascending order of opcode.
inline constexpr std::array opcode_table{
    OpcodeEntry{Opcode::identify,
                "identify",
                Direction::to_device,
                {},
                Opcode::identity,
                {10'000, 0},
                "Asks what the device is."},
    OpcodeEntry{Opcode::reset,
                "reset",
                Direction::to_device,
                {},
                {},
                {16'666'667, 0},
                "Brings the device to its state at power-on: image black, window the whole screen, no error, "
                "counters zero."},
    OpcodeEntry{Opcode::status,
                "status",
                Direction::to_device,
                {},
                Opcode::state,
                {10'000, 0},
                "Asks for the first error since the reset and for the counters; changes neither."},
    OpcodeEntry{Opcode::window,
                "window",
                Direction::to_device,
                layout::rectangle,
                {},
                {10'000, 0},
                "Sets the address window, and the writing position to its top left."},
    OpcodeEntry{Opcode::pixels,
                "pixels",
                Direction::to_device,
                layout::pixels,
                {},
                {10'000, 400},
                "Writes pixels from the writing position on, along the rows of the window from the left and "
                "from the top; after its last pixel it goes on at its first."},
    OpcodeEntry{Opcode::clear,
                "clear",
                Direction::to_device,
                {},
                {},
                {16'666'667, 0},
                "Makes the whole image black; window and writing position stay."},
    OpcodeEntry{Opcode::fill,
                "fill",
                Direction::to_device,
                layout::fill,
                {},
                {10'000, 50},
                "Fills a rectangle with one colour, inside the window or not; window and writing position "
                "stay."},
    OpcodeEntry{Opcode::read,
                "read",
                Direction::to_device,
                layout::rectangle,
                Opcode::row,
                {10'000, 400},
                "Asks for the pixels of a rectangle: one reply a row, from the top."},
    OpcodeEntry{Opcode::checksum,
                "checksum",
                Direction::to_device,
                layout::rectangle,
                Opcode::sum,
                {10'000, 400},
                "Asks for the checksum of a rectangle."},
    OpcodeEntry{
        Opcode::identity, "identity", Direction::to_host, layout::identity, {}, {}, "Answers identify."},
    OpcodeEntry{Opcode::state, "state", Direction::to_host, layout::state, {}, {}, "Answers status."},
    OpcodeEntry{
        Opcode::row, "row", Direction::to_host, layout::row, {}, {}, "Answers read: a row of the rectangle."},
    OpcodeEntry{Opcode::sum, "sum", Direction::to_host, layout::sum, {}, {}, "Answers checksum."},
};

/// The entry of an opcode that travels in this direction, null if there is none.
constexpr const OpcodeEntry* find(std::uint8_t opcode, Direction direction) {
  for (const OpcodeEntry& entry : opcode_table) {
    if (static_cast<std::uint8_t>(entry.opcode) == opcode && entry.direction == direction) return &entry;
  }
  return nullptr;
}

/// The entry of an opcode.
constexpr const OpcodeEntry& entry_of(Opcode opcode) {
  for (const OpcodeEntry& entry : opcode_table) {
    if (entry.opcode == opcode) return entry;
  }
  throw std::logic_error("opcode without an entry"); // a constant expression cannot get here: see the tests
}

/// Where an operand stands in its layout, settled when the program is compiled.
consteval std::size_t index_of(Opcode opcode, std::string_view name) {
  const std::span<const Operand> operands = entry_of(opcode).operands;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].name == name) return i;
  }
  throw std::logic_error("no such operand");
}

/// Bytes of a number; 0 for pixels and text, whose size varies.
constexpr std::size_t size_of(OperandType type) {
  switch (type) {
  case OperandType::u8:
    return 1;
  case OperandType::u16:
    return 2;
  case OperandType::u32:
    return 4;
  case OperandType::pixels:
  case OperandType::text:
    break;
  }
  return 0;
}

/// The largest number of operands in a layout.
inline constexpr std::size_t operand_limit = 8;

} // namespace halftone::protocol
