#pragma once
// A link that a second thread may speak over.

#include <halftone/link/link.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <span>

namespace halftone::link {

/// Over another link. Any thread may send whole commands at any time; one of them receives, the one whose
/// commands have replies.
class SharedLink final : public Link {
public:
  explicit SharedLink(std::unique_ptr<Link> over) : over_(std::move(over)) {}

  void send(std::span<const std::uint8_t> bytes) override;
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override;
  bool has_way_back() const override;
  void finish() override;
  void cut() override;

private:
  std::mutex mutex_; ///< guards what the other link does
  std::unique_ptr<Link> over_;
};

} // namespace halftone::link
