#include <halftone/link/faults.h>

#include <array>
#include <sstream>

namespace halftone::link {

namespace {

/// Below `limit`. Not by a standard distribution, for those differ between libraries.
std::size_t below(std::mt19937_64& random, std::size_t limit) { return random() % limit; }

bool one_in(std::mt19937_64& random, std::size_t count) { return below(random, count) == 0; }

} // namespace

Faults faults_of(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // From a link that damages each long command to one that damages few.
  const auto apart = [&] { return std::size_t{1000} << below(random, 6); };
  Faults faults{.seed = seed};
  if (one_in(random, 2)) faults.flipped = apart();
  if (one_in(random, 2)) faults.dropped = apart();
  if (one_in(random, 2)) faults.truncated = apart();
  if (one_in(random, 4)) faults.delayed = 8 * apart();
  if (one_in(random, 6)) faults.closed_after = below(random, 40'000);
  if (one_in(random, 3)) faults.restarted_after = below(random, 40'000);
  return faults;
}

std::string describe(const Faults& faults) {
  std::ostringstream text;
  text << "seed " << faults.seed;
  const auto tell = [&](const char* what, std::size_t bytes) {
    if (bytes != never) text << ", " << what << " " << bytes;
  };
  tell("flipped", faults.flipped);
  tell("dropped", faults.dropped);
  tell("truncated", faults.truncated);
  tell("delayed", faults.delayed);
  tell("closed after", faults.closed_after);
  tell("restarted after", faults.restarted_after);
  return text.str();
}

FaultyCable::FaultyCable(const Faults& faults)
    : faults_(faults),
      random_(faults.seed),
      flip_at_(after(faults.flipped)),
      drop_at_(after(faults.dropped)),
      truncate_at_(after(faults.truncated)),
      delay_at_(after(faults.delayed)) {}

Passed FaultyCable::pass(std::span<const std::uint8_t> bytes) {
  Passed passed;
  passed.closed = position_ > faults_.closed_after;
  if (passed.closed) return passed;
  passed.bytes.reserve(bytes.size());
  bool lost = false;
  for (const std::uint8_t byte : bytes) {
    const std::size_t here = position_++;
    if (here == faults_.closed_after) {
      ++count_;
      passed.closed = true;
      return passed;
    }
    if (here == faults_.restarted_after) {
      ++count_;
      passed.restarted = true;
      lost = true;
    }
    if (here == truncate_at_) {
      ++count_;
      truncate_at_ = here + after(faults_.truncated);
      lost = true;
    }
    if (here == drop_at_) {
      ++count_;
      drop_until_ = here + 1 + below(random_, faults_.drop_limit);
      drop_at_ = here + after(faults_.dropped);
    }
    if (here == delay_at_) {
      ++count_;
      passed.delay += std::chrono::milliseconds(1 + below(random_, std::size_t(faults_.delay_limit.count())));
      delay_at_ = here + after(faults_.delayed);
    }
    const bool flips = here == flip_at_;
    if (flips) flip_at_ = here + after(faults_.flipped);
    if (lost || here < drop_until_) continue;
    if (flips) ++count_;
    passed.bytes.push_back(flips ? static_cast<std::uint8_t>(byte ^ 1U << below(random_, 8)) : byte);
  }
  return passed;
}

/// Bytes to the next fault of a kind, at least 1.
std::size_t FaultyCable::after(std::size_t average) {
  return average == never ? never : 1 + below(random_, 2 * average);
}

} // namespace halftone::link
