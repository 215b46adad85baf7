#include "big_endian.h"

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/decoder.h>

#include <algorithm>

namespace halftone::protocol {

Decoder::Decoder(Direction direction) : direction_(direction), kept_{} {}

std::optional<Item> Decoder::next(std::span<const std::uint8_t>& bytes) {
  return scan(bytes, Kept::waits_for_more);
}

std::optional<Item> Decoder::drain() {
  std::span<const std::uint8_t> nothing;
  return scan(nothing, Kept::is_all);
}

std::size_t Decoder::missing() const {
  const std::size_t have = end_ - begin_;
  if (have == 0 && damaged_ == 0) return 0;
  if (have < header_size) return header_size - have;
  const std::span<const std::uint8_t> header =
      std::span<const std::uint8_t>(kept_).subspan(begin_, header_size);
  return header_size + load_big_endian(header.subspan(7, 2)) + checksum_size - have;
}

// After a wrong checksum the scan goes on one byte after the false or damaged frame's start, not after its
// end: its length may be what is damaged, and good frames may lie inside it.
std::optional<Item> Decoder::scan(std::span<const std::uint8_t>& bytes, Kept kept) {
  while (true) {
    const auto header = [this] { return std::span<const std::uint8_t>(kept_).subspan(begin_, header_size); };
    bool whole = keep(header_size, bytes);
    if (whole) {
      const std::size_t length = load_big_endian(header().subspan(7, 2));
      if (load_big_endian(header().first(2)) != sync_word || length > payload_limit) {
        skip_byte();
        continue;
      }
      const std::size_t size = header_size + length + checksum_size;
      whole = keep(size, bytes);
      if (whole) {
        if (std::optional<Item> item = decode_frame(size)) return item;
        skip_byte();
        continue;
      }
    }
    if (kept == Kept::waits_for_more) return std::nullopt;
    if (begin_ == end_) return damaged_ == 0 ? std::nullopt : std::optional(take_damage());
    skip_byte();
  }
}

/// The item of the frame at begin_, or the damage before it; nothing if its checksum is wrong.
std::optional<Item> Decoder::decode_frame(std::size_t size) {
  const std::span<const std::uint8_t> frame = std::span<const std::uint8_t>(kept_).subspan(begin_, size);
  const std::span<const std::uint8_t> checked = frame.first(size - checksum_size);
  if (load_big_endian(frame.last(checksum_size)) != checksum(checked)) return std::nullopt;
  if (damaged_ != 0) return take_damage(); // and the frame the next time

  last_sequence_ = load_big_endian(frame.subspan(3, 4));
  Item item{offset_, size, parse({frame[2], last_sequence_, checked.subspan(header_size)}, direction_)};
  begin_ += size;
  offset_ += size;
  return item;
}

/// Takes from the front of `bytes` until `size` bytes are kept; false if there are not enough.
bool Decoder::keep(std::size_t size, std::span<const std::uint8_t>& bytes) {
  const std::size_t have = end_ - begin_;
  if (have >= size) return true;
  if (have == 0) {
    begin_ = end_ = 0;
  } else if (begin_ + size > kept_.size()) {
    std::copy(kept_.begin() + begin_, kept_.begin() + end_, kept_.begin());
    begin_ = 0;
    end_ = have;
  }
  const std::size_t taken = std::min(size - have, bytes.size());
  std::ranges::copy(bytes.first(taken), kept_.begin() + end_);
  bytes = bytes.subspan(taken);
  end_ += taken;
  return have + taken == size;
}

/// Zeros are damage only in the midst of damage; else they are fill.
void Decoder::skip_byte() {
  if (damaged_ != 0 || kept_[begin_] != 0) ++damaged_;
  ++begin_;
  ++offset_;
}

Item Decoder::take_damage() {
  const Item item{offset_ - damaged_, damaged_, Rejection{Fault::damaged, last_sequence_, 0}};
  damaged_ = 0;
  return item;
}

} // namespace halftone::protocol
