#include <halftone/watch/tape.h>

#include <halftone/recording/read.h>

#include <iterator>
#include <utility>

namespace halftone::watch {

void Tape::append(std::span<const std::uint8_t> bytes) {
  if (recording::is_recording(bytes)) return; // the header: who watches knows the device at the beginning
  std::vector<recording::Record> records = recording::read_records(bytes);
  const std::lock_guard lock(mutex_);
  std::ranges::move(records, std::back_inserter(records_));
  changed_.notify_one();
}

void Tape::wake() {
  const std::lock_guard lock(mutex_);
  awake_ = true;
  changed_.notify_one();
}

std::vector<recording::Record> Tape::take(std::chrono::steady_clock::time_point until) {
  std::unique_lock lock(mutex_);
  changed_.wait_until(lock, until, [&] { return awake_ || !records_.empty(); });
  awake_ = false;
  return std::exchange(records_, {});
}

} // namespace halftone::watch
