#pragma once
// The layouts of the payloads that opcodes.h lists.

#include <halftone/protocol/operand.h>

#include <array>
#include <cstdint>

namespace halftone::protocol::layout {

inline constexpr std::uint32_t u8_most = 0xFF;
inline constexpr std::uint32_t u16_most = 0xFFFF;
inline constexpr std::uint32_t u32_most = 0xFFFFFFFF;

inline constexpr Operand x{"x", OperandType::u16, 0, screen_width - 1, "left column, 0 at the left"};
inline constexpr Operand y{"y", OperandType::u16, 0, screen_height - 1, "top row, 0 at the top"};
inline constexpr Operand width{"width", OperandType::u16, 1, screen_width, "columns", 0, screen_width};
inline constexpr Operand height{"height", OperandType::u16, 1, screen_height, "rows", 1, screen_height};
inline constexpr Operand red{"red", OperandType::u8, 0, u8_most, "red of the colour"};
inline constexpr Operand green{"green", OperandType::u8, 0, u8_most, "green of the colour"};
inline constexpr Operand blue{"blue", OperandType::u8, 0, u8_most, "blue of the colour"};
inline constexpr Operand on{"on", OperandType::u8, 0, 1, "1 where it is shown, 0 where not"};
inline constexpr Operand blink{"blink", OperandType::u8, 0, u8_most,
                               "shown for so many fields, then not for as many; 0: always shown"};
inline constexpr Operand lut_channels{"channels", OperandType::u8, 1, 7,
                                      "the tables meant: 1 red, 2 green, 4 blue, and their sums"};

inline constexpr std::array wait{
    Operand{"fields", OperandType::u16, 1, u16_most, "vertical blanks to wait for"}};
inline constexpr std::array mark{Operand{"name", OperandType::text, 1, 64, "of the place in the stream"}};

inline constexpr std::array rectangle{x, y, width, height};
inline constexpr std::array pixels{Operand{"pixels", OperandType::pixels, 1, payload_limit / channels,
                                           "red, green, blue of each, a byte each"}};
inline constexpr std::array fill{x, y, width, height, red, green, blue};
inline constexpr std::array runs{Operand{"runs", OperandType::runs, 1, payload_limit / (1 + channels),
                                         "length less 1, red, green, blue of each, a byte each"}};
inline constexpr std::array repeat{
    Operand{"count", OperandType::u32, 1, screen_width* screen_height, "pixels"}, red, green, blue};
inline constexpr std::array copy{
    x,
    y,
    width,
    height,
    Operand{"to_x", OperandType::u16, 0, screen_width - 1, "left column of the copy", 2, screen_width},
    Operand{"to_y", OperandType::u16, 0, screen_height - 1, "top row of the copy", 3, screen_height},
    Operand{"from", OperandType::u8, 0, 1, "the image buffer that is copied from"}};
inline constexpr std::array mask{Operand{"red", OperandType::u8, 0, u8_most, "bits of red"},
                                 Operand{"green", OperandType::u8, 0, u8_most, "bits of green"},
                                 Operand{"blue", OperandType::u8, 0, u8_most, "bits of blue"}};
inline constexpr std::array buffers{
    Operand{"written", OperandType::u8, 0, 1, "the image buffer that is written, and read back"},
    Operand{"shown", OperandType::u8, 0, 1, "the image buffer that is shown"}};

inline constexpr std::array read_lut{
    Operand{"channel", OperandType::u8, 0, 2, "the table meant: 0 red, 1 green, 2 blue"}};
inline constexpr std::array read_overlay{
    y, Operand{"height", OperandType::u16, 1, screen_height, "rows", 0, screen_height}};

inline constexpr std::array lut{
    lut_channels, Operand{"first", OperandType::u8, 0, u8_most, "the first entry set"},
    Operand{"values", OperandType::bytes, 1, 256, "of the entries from there on", 1, 256}};
inline constexpr std::array ramp{lut_channels,
                                 Operand{"first", OperandType::u8, 0, u8_most - 1, "the first entry set"},
                                 Operand{"count", OperandType::u16, 2, 256, "entries set", 1, 256},
                                 Operand{"from", OperandType::u8, 0, u8_most, "value of the first"},
                                 Operand{"to", OperandType::u8, 0, u8_most, "value of the last"}};
inline constexpr std::array pan{
    Operand{"x", OperandType::u16, 0, screen_width - 1, "column of the image at the left of the screen"},
    Operand{"y", OperandType::u16, 0, screen_height - 1, "row of the image at the top of the screen"}};
inline constexpr std::array zoom{
    Operand{"shift", OperandType::u8, 0, 3, "each pixel is shown 1, 2, 4 or 8 times across and down"}};
inline constexpr std::array blank{
    Operand{"on", OperandType::u8, 0, 1, "1: nothing is shown; 0: the image is"}};
inline constexpr std::array border{
    Operand{"thickness", OperandType::u8, 0, u8_most, "pixels at every side of the screen; 0: no border"},
    red, green, blue};

inline constexpr std::array overlay{on, blink, red, green, blue};
inline constexpr std::array overlay_bits{
    Operand{"x8", OperandType::u8, 0, screen_width / 8 - 1, "left column, divided by 8"}, y,
    Operand{"bits", OperandType::bytes, 1, screen_width / 8,
            "eight pixels a byte, the highest bit at the left", 0, screen_width / 8}};
inline constexpr std::array overlay_fill{
    x, y, width, height, Operand{"value", OperandType::u8, 0, 1, "of every pixel of the rectangle"}};
inline constexpr std::array cursor{
    Operand{"x", OperandType::u16, 0, screen_width - 1, "column of the screen at the pattern's left"},
    Operand{"y", OperandType::u16, 0, screen_height - 1, "row of the screen at the pattern's top"},
    on,
    blink,
    red,
    green,
    blue};
inline constexpr std::array cursor_pattern{
    Operand{"bits", OperandType::bytes, 32, 32, "16 rows of 16 pixels, the highest bit at the left"}};

inline constexpr std::array identity{
    Operand{"profile", OperandType::u8, 0, u8_most, "command set: 0 is this reconstruction"},
    Operand{"version", OperandType::u8, 0, u8_most, "version of the protocol"},
    Operand{"width", OperandType::u16, 1, u16_most, "columns of the screen"},
    Operand{"height", OperandType::u16, 1, u16_most, "rows of the screen"},
    Operand{"name", OperandType::text, 1, 64, "the device's name"}};
inline constexpr std::array state{
    Operand{"error", OperandType::u8, 0, u8_most, "first error since the reset, 0 if there was none"},
    Operand{"error_sequence", OperandType::u32, 0, u32_most, "sequence number of the command in error"},
    Operand{"errors", OperandType::u32, 0, u32_most, "errors since the reset"},
    Operand{"commands", OperandType::u32, 0, u32_most, "commands executed since the reset, without queries"},
    Operand{"skipped", OperandType::u32, 0, u32_most, "damaged bytes skipped since the reset"},
    Operand{"fields", OperandType::u32, 0, u32_most, "fields begun since power-on"}};
inline constexpr std::array row{
    x, y, Operand{"pixels", OperandType::pixels, 1, screen_width, "from the left", 0, screen_width}};
inline constexpr std::array sum{
    Operand{"checksum", OperandType::u32, 0, u32_most, "CRC-32 of the rectangle's bytes in row order"}};
inline constexpr std::array table{
    Operand{"channel", OperandType::u8, 0, 2, "the table: 0 red, 1 green, 2 blue"},
    Operand{"values", OperandType::bytes, 256, 256, "of its entries"}};
inline constexpr std::array bits{y, Operand{"bits", OperandType::bytes, screen_width / 8, screen_width / 8,
                                            "eight pixels a byte, the highest bit at the left"}};

} // namespace halftone::protocol::layout
