#pragma once
// A link that fails, the same way for the same seed.

#include <halftone/link/link.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace halftone::test {

/// How often what happens: one in so many bytes, or pieces sent; 0 for never.
struct Faults {
  std::uint64_t seed = 0;
  std::size_t flipped_byte = 0;
  std::size_t dropped_byte = 0;
  std::size_t dropped_piece = 0;
  std::size_t truncated_piece = 0;
  std::size_t closes_after = std::size_t(-1); ///< bytes, both ways together
};

std::string describe(const Faults& faults);

/// To a device in memory, so that it knows at once when nothing will come.
class FaultyLink final : public link::Link {
public:
  explicit FaultyLink(const Faults& faults);
  void send(std::span<const std::uint8_t> bytes) override;
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override;

  std::size_t faults_done = 0;

private:
  bool happens(std::size_t one_in);
  std::vector<std::uint8_t> spoilt(std::span<const std::uint8_t> bytes);
  void count(std::size_t bytes);

  Faults faults_;
  std::mt19937_64 random_;
  std::size_t bytes_ = 0;
  std::unique_ptr<link::Link> device_ = link::open("mem:");
};

} // namespace halftone::test
