#pragma once
// From a stream of bytes, in pieces of any size, to messages. Never throws, never guesses: what is not a
// whole frame with the right checksum is skipped and reported, and the next whole frame is found again.

#include <halftone/protocol/message.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

namespace halftone::protocol {

/// A message or a rejection, and the bytes of the stream that it is made of. Bytes that belong to no item are
/// fill: zeros between frames.
struct Item {
  std::uint64_t offset = 0; ///< from the start of the stream
  std::uint64_t size = 0;   ///< in bytes
  std::variant<Message, Rejection> content;
};

/// A value: a copy made in mid-stream goes on as the original does. Keeps at most one frame; the time for a
/// byte is bounded by the checksum of one frame (reached only by streams made of false headers).
class Decoder {
public:
  /// Takes frames that travel in this direction; others have an unknown opcode.
  explicit Decoder(Direction direction);

  /// The next item, taking from the front of `bytes` what it needs; nothing if all of them are taken and more
  /// are needed. How the stream is cut into pieces does not change the items. The item's data are valid until
  /// the next call. Damage is reported when the next whole frame shows where it ends.
  std::optional<Item> next(std::span<const std::uint8_t>& bytes);

  /// The next item in what is kept, given that an unfinished frame will not be finished; nothing if nothing
  /// is left. To be called until then at the end of a stream, or when one has waited too long for the rest.
  std::optional<Item> drain();

  /// Bytes that what is kept lacks to be a whole frame, as far as can be told; 0 where nothing is kept that
  /// later bytes could become a part of, and no damage waits to be reported.
  std::size_t missing() const;

private:
  enum class Kept { waits_for_more, is_all };
  std::optional<Item> scan(std::span<const std::uint8_t>& bytes, Kept kept);
  std::optional<Item> decode_frame(std::size_t size);
  bool keep(std::size_t size, std::span<const std::uint8_t>& bytes);
  void skip_byte();
  Item take_damage();

  Direction direction_;
  std::array<std::uint8_t, frame_limit> kept_; ///< from begin_ to end_
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint64_t offset_ = 0;        ///< of begin_ in the stream
  std::uint64_t damaged_ = 0;       ///< bytes before begin_ that are skipped and not yet reported
  std::uint32_t last_sequence_ = 0; ///< of the last good frame
};

} // namespace halftone::protocol
