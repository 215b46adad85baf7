#pragma once
// A link that a second thread may speak over.

#include <halftone/link/link.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <span>
#include <stop_token>
#include <thread>
#include <vector>

namespace halftone::link {

/// Over another link. Any thread may send whole commands at any time; one of them receives, the one whose
/// commands have replies.
class SharedLink final : public Link {
public:
  explicit SharedLink(std::unique_ptr<Link> over);
  ~SharedLink() override;
  SharedLink(const SharedLink&) = delete;
  SharedLink& operator=(const SharedLink&) = delete;

  /// Sends whole commands as soon as may be, in the order of the calls, without waiting for a device that
  /// does not take them: one that does has them when it returns. Throws what has failed with earlier ones.
  void post(std::vector<std::uint8_t> bytes);

  /// Throws what has failed with posted commands, but not what a cut has broken off.
  void check() const;

  /// All that was posted has been sent; where the device does not take it for as long as `patience`, the link
  /// is cut. Throws as check() does. Nothing may be posted after it.
  void settle(std::chrono::milliseconds patience);

  void send(std::span<const std::uint8_t> bytes) override;
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override;
  bool has_way_back() const override;
  void finish() override;
  void cut() override;

private:
  std::unique_lock<std::mutex> take();
  void send_posted(const std::stop_token& end);
  void end_posting(std::exception_ptr failure);
  void stop_posting(std::chrono::milliseconds patience);

  std::mutex next_;  ///< of who takes the other one next
  std::mutex mutex_; ///< guards what the other link does
  std::unique_ptr<Link> over_;
  std::atomic<bool> is_cut_ = false;

  mutable std::mutex posting_; ///< guards what follows
  std::condition_variable_any changed_;
  std::deque<std::vector<std::uint8_t>> posted_; ///< the first is being sent
  bool has_ended_ = false;                       ///< nothing of it is sent any more
  std::exception_ptr failure_;

  std::jthread poster_; ///< the last: it uses the others
};

} // namespace halftone::link
