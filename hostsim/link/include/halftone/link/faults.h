#pragma once
// Faults of a link and its device, the same ones for the same seed and the same bytes.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace halftone::link {

inline constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

/// How far apart faults are on average, in bytes that travel in either direction. How the bytes are cut into
/// pieces makes no difference to any but `truncated`.
struct Faults {
  std::uint64_t seed = 0;
  std::size_t flipped = never;               ///< one bit
  std::size_t dropped = never;               ///< from 1 to drop_limit bytes in a row
  std::size_t truncated = never;             ///< the rest of a piece is lost
  std::size_t delayed = never;               ///< for up to delay_limit
  std::size_t closed_after = never;          ///< bytes, once
  std::size_t restarted_after = never;       ///< bytes, once: the device goes off and on
  std::size_t drop_limit = 1500;             ///< at least 1
  std::chrono::milliseconds delay_limit{10}; ///< at least 1
};

/// A link that is bad in one way or in several, by the seed: it may flip, drop, truncate, delay, close at
/// some byte, or lose its device at some byte.
Faults faults_of(std::uint64_t seed);

/// For messages.
std::string describe(const Faults& faults);

/// What has become of a piece.
struct Passed {
  std::vector<std::uint8_t> bytes;    ///< that arrive
  std::chrono::milliseconds delay{0}; ///< before they do
  bool closed = false;                ///< after them: nothing passes any more
  bool restarted = false; ///< after them: the device has forgotten everything, and what follows them is lost
};

/// The stretch of a cable on which it happens.
class FaultyCable {
public:
  explicit FaultyCable(const Faults& faults);

  Passed pass(std::span<const std::uint8_t> bytes);

  /// Faults so far.
  std::size_t count() const { return count_; }

private:
  std::size_t after(std::size_t average);

  Faults faults_;
  std::mt19937_64 random_;
  std::size_t position_ = 0; ///< bytes that have come, both ways
  std::size_t flip_at_, drop_at_, truncate_at_, delay_at_;
  std::size_t drop_until_ = 0;
  std::size_t count_ = 0;
};

} // namespace halftone::link
