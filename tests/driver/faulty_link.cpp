#include "faulty_link.h"

#include <algorithm>
#include <sstream>

namespace halftone::test {

std::string describe(const Faults& faults) {
  std::ostringstream text;
  text << "seed " << faults.seed << ", flips a byte in " << faults.flipped_byte << ", drops a byte in "
       << faults.dropped_byte << ", drops a piece in " << faults.dropped_piece << ", truncates a piece in "
       << faults.truncated_piece << ", closes after " << faults.closes_after;
  return text.str();
}

FaultyLink::FaultyLink(const Faults& faults) : faults_(faults), random_(faults.seed) {}

void FaultyLink::send(std::span<const std::uint8_t> bytes) {
  count(bytes.size());
  device_->send(spoilt(bytes));
}

std::size_t FaultyLink::receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) {
  while (true) {
    // Small pieces, for a piece is what gets lost at once.
    std::vector<std::uint8_t> piece(std::min<std::size_t>(bytes.size(), 1000));
    piece.resize(device_->receive(piece, timeout));
    count(piece.size());
    piece = spoilt(piece);
    std::ranges::copy(piece, bytes.begin());
    if (!piece.empty()) return piece.size();
  }
}

bool FaultyLink::happens(std::size_t one_in) {
  const bool now = one_in != 0 && random_() % one_in == 0;
  if (now) ++faults_done;
  return now;
}

std::vector<std::uint8_t> FaultyLink::spoilt(std::span<const std::uint8_t> bytes) {
  if (happens(faults_.dropped_piece)) return {};
  if (!bytes.empty() && happens(faults_.truncated_piece)) bytes = bytes.first(random_() % bytes.size());
  std::vector<std::uint8_t> result;
  for (const std::uint8_t byte : bytes) {
    if (happens(faults_.dropped_byte)) continue;
    result.push_back(happens(faults_.flipped_byte) ? static_cast<std::uint8_t>(byte ^ 1U << random_() % 8)
                                                   : byte);
  }
  return result;
}

void FaultyLink::count(std::size_t bytes) {
  bytes_ += bytes;
  if (bytes_ > faults_.closes_after) throw link::DeviceError("the device closed the connection");
}

} // namespace halftone::test
