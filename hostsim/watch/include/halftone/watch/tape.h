#pragma once
// What a device is sent, on its way from the thread that records it to the one that watches.

#include <halftone/recording/trace.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace halftone::watch {

/// Both threads may call at any time.
class Tape {
public:
  /// A sink for a recording::Writer: the header, then whole records.
  void append(std::span<const std::uint8_t> bytes);

  /// Lets take() return, as there is something else to look at.
  void wake();

  /// The records since the last time, as soon as there is one, or somebody wakes, or the time is over.
  std::vector<recording::Record> take(std::chrono::steady_clock::time_point until);

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<recording::Record> records_;
  bool awake_ = false;
};

} // namespace halftone::watch
