#include <halftone/link/faulty_link.h>

#include <algorithm>
#include <string>
#include <thread>

namespace halftone::link {

namespace {

using Clock = std::chrono::steady_clock;

/// Small pieces, for a piece is what gets lost at once.
constexpr std::size_t largest_piece = 1000;

class FaultyLink final : public Link {
public:
  FaultyLink(const Faults& faults, const Opening& open) : cable_(faults), open_(open), device_(open()) {}

  void send(std::span<const std::uint8_t> bytes) override {
    if (is_closed_) fail_as_closed();
    while (!bytes.empty()) {
      const std::span<const std::uint8_t> piece = bytes.first(std::min(bytes.size(), largest_piece));
      bytes = bytes.subspan(piece.size());
      const Passed passed = cable_.pass(piece);
      std::this_thread::sleep_for(passed.delay);
      device_->send(passed.bytes);
      settle(passed);
      if (is_closed_) fail_as_closed();
    }
  }

  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    const auto deadline = Clock::now() + timeout;
    while (true) {
      if (arriving_.empty()) fetch(bytes.size(), deadline);
      if (due_ > deadline) {
        std::this_thread::sleep_until(deadline);
        throw Timeout("the link is slow");
      }
      std::this_thread::sleep_until(due_);
      const std::size_t count = std::min(bytes.size(), arriving_.size());
      std::copy_n(arriving_.begin(), count, bytes.begin());
      arriving_.erase(arriving_.begin(), arriving_.begin() + static_cast<std::ptrdiff_t>(count));
      if (count != 0) return count;
    }
  }

  bool has_way_back() const override { return device_->has_way_back(); }

  void finish() override { device_->finish(); }

  void cut() override { device_->cut(); }

private:
  void fetch(std::size_t most, Clock::time_point deadline) {
    if (is_closed_) fail_as_closed();
    std::vector<std::uint8_t> piece(std::min(most, largest_piece));
    const auto left = std::max(deadline - Clock::now(), Clock::duration::zero());
    piece.resize(device_->receive(piece, std::chrono::ceil<std::chrono::milliseconds>(left)));
    Passed passed = cable_.pass(piece);
    due_ = Clock::now() + passed.delay;
    settle(passed);
    arriving_ = std::move(passed.bytes);
  }

  [[noreturn]] static void fail_as_closed() { throw DeviceError("the device closed the connection"); }

  void settle(const Passed& passed) {
    is_closed_ = is_closed_ || passed.closed;
    if (!passed.restarted) return;
    device_.reset(); // an address may be free only then
    device_ = open_();
  }

  FaultyCable cable_;
  Opening open_;
  std::unique_ptr<Link> device_;
  std::vector<std::uint8_t> arriving_; ///< for the host
  Clock::time_point due_;              ///< when
  bool is_closed_ = false;             ///< after what is arriving
};

} // namespace

std::unique_ptr<Link> open_faulty_link(const Faults& faults, const Opening& open) {
  return std::make_unique<FaultyLink>(faults, open);
}

} // namespace halftone::link
