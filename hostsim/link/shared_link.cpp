#include <halftone/link/shared_link.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace halftone::link {

namespace {

/// How long somebody who sends may have to wait for somebody who receives.
constexpr std::chrono::milliseconds turn(5);
/// How long somebody who posts waits: a device that takes what it is sent has it by then, so that the next
/// key finds what this one has done; and a person does not notice.
constexpr std::chrono::milliseconds moment(20);

/// For those who have not settled the link.
constexpr std::chrono::milliseconds last_patience(500);

} // namespace

SharedLink::SharedLink(std::unique_ptr<Link> over)
    : over_(std::move(over)),
      poster_([this](const std::stop_token& end) { send_posted(end); }) {}

SharedLink::~SharedLink() { stop_posting(last_patience); }

void SharedLink::post(std::vector<std::uint8_t> bytes) {
  assert(poster_.joinable());
  check();
  std::unique_lock lock(posting_);
  // Behind what has not been taken in its own moment there is nothing to wait for: many keys are not to take
  // many moments.
  const bool is_next = posted_.empty();
  posted_.push_back(std::move(bytes));
  changed_.notify_all();
  if (is_next) changed_.wait_for(lock, moment, [&] { return posted_.empty() || has_ended_; });
}

void SharedLink::check() const {
  const std::lock_guard lock(posting_);
  if (failure_) std::rethrow_exception(failure_);
}

void SharedLink::settle(std::chrono::milliseconds patience) {
  stop_posting(patience);
  check();
}

void SharedLink::stop_posting(std::chrono::milliseconds patience) {
  {
    std::unique_lock lock(posting_);
    if (!changed_.wait_for(lock, patience, [&] { return posted_.empty() || has_ended_; })) cut();
  }
  poster_.request_stop();
  if (poster_.joinable()) poster_.join();
}

void SharedLink::send_posted(const std::stop_token& end) {
  try {
    while (true) {
      std::unique_lock lock(posting_);
      if (!changed_.wait(lock, end, [&] { return !posted_.empty(); })) return;
      const std::vector<std::uint8_t>& next = posted_.front(); // which stays where others are added
      lock.unlock();
      send(next);
      lock.lock();
      posted_.pop_front();
      changed_.notify_all();
    }
  } catch (const DeviceError&) {
    end_posting(is_cut_ ? nullptr : std::current_exception()); // a cut breaks off what is being sent
  } catch (...) {
    end_posting(std::current_exception());
  }
}

void SharedLink::end_posting(std::exception_ptr failure) {
  const std::lock_guard lock(posting_);
  has_ended_ = true;
  failure_ = std::move(failure);
  changed_.notify_all();
}

/// A mutex alone may go, again and again, to somebody who gives it up and wants it back at once.
std::unique_lock<std::mutex> SharedLink::take() {
  const std::lock_guard first_in_line(next_);
  return std::unique_lock(mutex_);
}

void SharedLink::send(std::span<const std::uint8_t> bytes) {
  const auto lock = take();
  over_->send(bytes);
}

std::size_t SharedLink::receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + timeout;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    try {
      const auto lock = take();
      return over_->receive(bytes, std::clamp(left, std::chrono::milliseconds(0), turn));
    } catch (const Timeout&) {
      if (left <= turn) throw;
    }
  }
}

bool SharedLink::has_way_back() const { return over_->has_way_back(); }

void SharedLink::finish() {
  const auto lock = take();
  over_->finish();
}

void SharedLink::cut() {
  is_cut_ = true;
  over_->cut();
}

} // namespace halftone::link
