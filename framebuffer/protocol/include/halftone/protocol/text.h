#pragma once
// The text form of streams (docs/text-form.md): every stream of bytes whatsoever has one, and
// assemble(disassemble(stream)) == stream.

#include <halftone/protocol/opcodes.h>
#include <halftone/protocol/words.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::protocol {

/// What a line stands for, and the line without its end.
struct TextLine {
  std::uint64_t offset = 0; ///< of its bytes in the stream
  std::uint64_t size = 0;   ///< in bytes
  std::string text;
};

/// Calls take() for each line; their bytes are the stream, without gaps. Messages of this direction are
/// written by name.
void disassemble(std::span<const std::uint8_t> stream, Direction direction,
                 const std::function<void(const TextLine&)>& take);

std::string disassemble(std::span<const std::uint8_t> stream, Direction direction = Direction::to_device);

/// Of either direction. Throws TextError, whose message begins with the name of the file if there is one.
std::vector<std::uint8_t> assemble(std::string_view text, const std::string& file = {});

/// Assembles line after line.
class Assembler {
public:
  /// Appends the bytes that a line stands for, none if it has no words.
  void append_line(Words& words, std::vector<std::uint8_t>& stream);

private:
  std::uint32_t sequence_ = 0; ///< of the last item that has one
};

/// Calls take(line, number) for the lines of a text, numbered from 1, without their ends.
void for_each_line(std::string_view text, const std::function<void(std::string_view, int)>& take);

} // namespace halftone::protocol
