#include <halftone/link/recording_link.h>

#include <utility>

namespace halftone::link {

namespace {

class RecordingLink final : public Link {
public:
  RecordingLink(std::unique_ptr<Link> over, recording::Writer& recording)
      : over_(std::move(over)),
        recording_(recording) {}

  void send(std::span<const std::uint8_t> bytes) override {
    recording_.data(bytes);
    over_->send(bytes);
  }
  std::size_t receive(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override {
    return over_->receive(bytes, timeout);
  }
  bool has_way_back() const override { return over_->has_way_back(); }

private:
  std::unique_ptr<Link> over_;
  recording::Writer& recording_;
};

} // namespace

std::unique_ptr<Link> open_recording_link(std::unique_ptr<Link> over, recording::Writer& recording) {
  return std::make_unique<RecordingLink>(std::move(over), recording);
}

} // namespace halftone::link
