#pragma once
// The opcode table: the single source of the commands and replies for encoder, decoder, assembler,
// disassembler and docs/protocol.md. A new command is a new row here, and what the device does about it.
//
// The set is a reconstruction (docs/protocol.md says from what). The costs are assumptions about a device of
// 1985: 10 us to interpret a command; a memory cycle of 400 ns for a pixel that is addressed, an eighth of it
// where memory is filled; one field of 1/60 s for a clear.

#include <halftone/protocol/layouts.h>
#include <halftone/protocol/operand.h>

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

enum class Opcode : std::uint8_t {
  identify = 0x01,
  reset = 0x02,
  status = 0x03,
  wait = 0x04,
  mark = 0x05,
  window = 0x10,
  pixels = 0x11,
  clear = 0x12,
  fill = 0x13,
  runs = 0x14,
  repeat = 0x15,
  copy = 0x16,
  write_mask = 0x17,
  buffers = 0x18,
  read = 0x20,
  checksum = 0x21,
  read_screen = 0x22,
  read_lut = 0x23,
  read_overlay = 0x24,
  lut = 0x30,
  ramp = 0x31,
  read_mask = 0x32,
  pan = 0x33,
  zoom = 0x34,
  blank = 0x35,
  border = 0x36,
  overlay = 0x40,
  overlay_bits = 0x41,
  overlay_fill = 0x42,
  cursor = 0x43,
  cursor_pattern = 0x44,
  // Replies: the number of a command that they answer, with the highest bit set.
  identity = 0x81,
  state = 0x83,
  row = 0xA0,
  sum = 0xA1,
  table = 0xA3,
  bits = 0xA4,
};

enum class Direction { to_device, to_host };

/// Time that the device is busy, without the bus: nanoseconds, and nanoseconds for each pixel of the
/// command's rectangle or data.
struct Cost {
  std::uint32_t command = 0;
  std::uint32_t pixel = 0;
};

inline constexpr std::uint32_t field_nanoseconds = 16'666'667; ///< 1/60 s, rounded

struct OpcodeEntry {
  Opcode opcode;
  std::string_view name;
  Direction direction;
  std::span<const Operand> operands; ///< in the order of the payload
  std::optional<Opcode> answer;      ///< the reply to it; commands that have one are called queries
  Cost cost;
  std::string_view meaning;
};

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
                {field_nanoseconds, 0},
                "Brings the device to its state at power-on: both images black, overlay and cursor empty and "
                "not shown, look-up tables linear, masks open, window the whole screen, no error, counters "
                "zero. The clock runs on."},
    OpcodeEntry{Opcode::status,
                "status",
                Direction::to_device,
                {},
                Opcode::state,
                {10'000, 0},
                "Asks for the first error since the reset and for the counters; changes neither."},
    OpcodeEntry{Opcode::wait,
                "wait",
                Direction::to_device,
                layout::wait,
                {},
                {10'000, 0},
                "Does nothing until so many vertical blanks have begun."},
    OpcodeEntry{Opcode::mark,
                "mark",
                Direction::to_device,
                layout::mark,
                {},
                {10'000, 0},
                "Names this place in the stream, for the tools; the device does nothing."},
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
    OpcodeEntry{
        Opcode::clear,
        "clear",
        Direction::to_device,
        {},
        {},
        {field_nanoseconds, 0},
        "Makes the whole written image black, whatever the write mask; window and writing position stay."},
    OpcodeEntry{
        Opcode::fill,
        "fill",
        Direction::to_device,
        layout::fill,
        {},
        {10'000, 50},
        "Fills a rectangle with one colour, inside the window or not; window and writing position stay."},
    OpcodeEntry{Opcode::runs,
                "runs",
                Direction::to_device,
                layout::runs,
                {},
                {10'000, 50},
                "Writes runs of 1 to 256 pixels of one colour, one after the other, as pixels does."},
    OpcodeEntry{Opcode::repeat,
                "repeat",
                Direction::to_device,
                layout::repeat,
                {},
                {10'000, 50},
                "Writes one colour so many times, as pixels does."},
    OpcodeEntry{Opcode::copy,
                "copy",
                Direction::to_device,
                layout::copy,
                {},
                {10'000, 800},
                "Copies a rectangle into the written image, from either; where the two overlap, as if it "
                "were read whole before it is written. Window and writing position stay."},
    OpcodeEntry{
        Opcode::write_mask,
        "write_mask",
        Direction::to_device,
        layout::mask,
        {},
        {10'000, 0},
        "Sets the bits that pixels, runs, repeat, fill and copy may change; the others stay as they are."},
    OpcodeEntry{Opcode::buffers,
                "buffers",
                Direction::to_device,
                layout::buffers,
                {},
                {10'000, 0},
                "Chooses the image buffer that is written and read back, and the one that is shown."},
    OpcodeEntry{Opcode::read,
                "read",
                Direction::to_device,
                layout::rectangle,
                Opcode::row,
                {10'000, 400},
                "Asks for the pixels of a rectangle of the written image: one reply a row, from the top."},
    OpcodeEntry{Opcode::checksum,
                "checksum",
                Direction::to_device,
                layout::rectangle,
                Opcode::sum,
                {10'000, 400},
                "Asks for the checksum of a rectangle of the written image."},
    OpcodeEntry{Opcode::read_screen,
                "read_screen",
                Direction::to_device,
                layout::rectangle,
                Opcode::row,
                {10'000, 400},
                "Asks for the pixels of a rectangle of the screen, as they are shown: one reply a row, from "
                "the top."},
    OpcodeEntry{Opcode::read_lut,
                "read_lut",
                Direction::to_device,
                layout::read_lut,
                Opcode::table,
                {10'000, 0},
                "Asks for a look-up table."},
    OpcodeEntry{Opcode::read_overlay,
                "read_overlay",
                Direction::to_device,
                layout::read_overlay,
                Opcode::bits,
                {10'000, 0},
                "Asks for rows of the overlay plane: one reply a row, from the top."},
    OpcodeEntry{Opcode::lut,
                "lut",
                Direction::to_device,
                layout::lut,
                {},
                {10'000, 0},
                "Sets an entry, or several in a row, of one or more look-up tables."},
    OpcodeEntry{Opcode::ramp,
                "ramp",
                Direction::to_device,
                layout::ramp,
                {},
                {10'000, 0},
                "Sets entries of look-up tables to a straight line: entry first + i gets from + i (to - "
                "from) / (count - 1), rounded to the nearest, halves away from `from`."},
    OpcodeEntry{Opcode::read_mask,
                "read_mask",
                Direction::to_device,
                layout::mask,
                {},
                {10'000, 0},
                "Sets the bits of the image that reach the look-up tables; the others are shown as 0. "
                "Read-back and checksum see all bits."},
    OpcodeEntry{Opcode::pan,
                "pan",
                Direction::to_device,
                layout::pan,
                {},
                {10'000, 0},
                "Moves the image on the screen; beyond its right and lower edge it goes on at its left and "
                "upper one."},
    OpcodeEntry{Opcode::zoom,
                "zoom",
                Direction::to_device,
                layout::zoom,
                {},
                {10'000, 0},
                "Enlarges the image on the screen by replication, from the top left of what is shown on. "
                "Overlay, cursor and border are not enlarged."},
    OpcodeEntry{Opcode::blank,
                "blank",
                Direction::to_device,
                layout::blank,
                {},
                {10'000, 0},
                "Makes the screen black, or shows it again; nothing else changes."},
    OpcodeEntry{Opcode::border,
                "border",
                Direction::to_device,
                layout::border,
                {},
                {10'000, 0},
                "Sets the thickness and the colour of the border, which covers image, overlay and cursor."},
    OpcodeEntry{Opcode::overlay,
                "overlay",
                Direction::to_device,
                layout::overlay,
                {},
                {10'000, 0},
                "Shows the overlay plane above the image, in one colour, or hides it. It is neither panned "
                "nor zoomed."},
    OpcodeEntry{Opcode::overlay_bits,
                "overlay_bits",
                Direction::to_device,
                layout::overlay_bits,
                {},
                {10'000, 0},
                "Writes pixels of a row of the overlay plane, to the right of a column, within the row."},
    OpcodeEntry{Opcode::overlay_fill,
                "overlay_fill",
                Direction::to_device,
                layout::overlay_fill,
                {},
                {10'000, 50},
                "Sets a rectangle of the overlay plane to 0 or 1."},
    OpcodeEntry{Opcode::cursor,
                "cursor",
                Direction::to_device,
                layout::cursor,
                {},
                {10'000, 0},
                "Moves the cursor, shows it above the overlay in one colour, or hides it. What lies beyond "
                "the screen is cut off."},
    OpcodeEntry{Opcode::cursor_pattern,
                "cursor_pattern",
                Direction::to_device,
                layout::cursor_pattern,
                {},
                {10'000, 0},
                "Sets the pixels of the cursor."},
    OpcodeEntry{
        Opcode::identity, "identity", Direction::to_host, layout::identity, {}, {}, "Answers identify."},
    OpcodeEntry{Opcode::state, "state", Direction::to_host, layout::state, {}, {}, "Answers status."},
    OpcodeEntry{Opcode::row,
                "row",
                Direction::to_host,
                layout::row,
                {},
                {},
                "Answers read and read_screen: a row of the rectangle."},
    OpcodeEntry{Opcode::sum, "sum", Direction::to_host, layout::sum, {}, {}, "Answers checksum."},
    OpcodeEntry{Opcode::table, "table", Direction::to_host, layout::table, {}, {}, "Answers read_lut."},
    OpcodeEntry{Opcode::bits,
                "bits",
                Direction::to_host,
                layout::bits,
                {},
                {},
                "Answers read_overlay: a row of the plane."},
};

/// The entry of an opcode that travels in this direction, null if there is none.
constexpr const OpcodeEntry* find(std::uint8_t opcode, Direction direction) {
  for (const OpcodeEntry& entry : opcode_table) {
    if (static_cast<std::uint8_t>(entry.opcode) == opcode && entry.direction == direction) return &entry;
  }
  return nullptr;
}

/// The entry of the name, null if there is none.
constexpr const OpcodeEntry* find(std::string_view name) {
  for (const OpcodeEntry& entry : opcode_table) {
    if (entry.name == name) return &entry;
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

} // namespace halftone::protocol
