#pragma once
// What other threads and processes bring about, in a time that nobody knows.

#include <chrono>
#include <functional>
#include <thread>

namespace halftone::test {

/// Tries again and again for a quarter of a minute, or so long; whether it came true.
inline bool comes_true(const std::function<bool()>& condition,
                       std::chrono::milliseconds patience = std::chrono::seconds(15)) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return condition();
}

} // namespace halftone::test
