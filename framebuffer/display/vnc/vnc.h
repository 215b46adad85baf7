#pragma once
// A VNC server that shows the device's screen to whoever connects, and lets nobody do anything to it.

#include "../listen/listener.h"
#include "picture.h"
#include "seat.h"

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::display {

class Vnc final : public Display {
public:
  /// HOST:PORT, by default 127.0.0.1:5900. Throws DisplayError, std::invalid_argument.
  explicit Vnc(std::string_view where);

  std::string address() const override { return name(listener_.endpoint()); }
  void show(const Frame& frame) override;
  void say(const Words& words) override { title_ = words.title; }
  std::vector<Event> poll() override;

private:
  void take_in(file::Descriptor client);

  Listener listener_;
  Picture picture_;
  std::string title_ = "Halftone";
  bool has_picture_ = false;
  std::array<std::unique_ptr<Seat>, 16> seats_;
};

} // namespace halftone::display
