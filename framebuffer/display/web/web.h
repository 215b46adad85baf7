#pragma once
// The screen in a browser: a VNC server on a port of its own, and websockify, which gives browsers noVNC and
// lets it reach that server.

#include "../listen/listener.h"
#include "child.h"

#include <halftone/display/display.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::display {

class Web final : public Display {
public:
  /// HOST:PORT, by default 127.0.0.1:6080. Waits until browsers are served. Throws DisplayError,
  /// std::invalid_argument.
  explicit Web(std::string_view where);

  std::string address() const override;
  void show(const Frame& frame) override { vnc_->show(frame); }
  void say(const Words& words) override { vnc_->say(words); }
  std::vector<Event> poll() override;

private:
  std::string reason();

  Endpoint endpoint_;
  std::unique_ptr<Display> vnc_;
  std::optional<Child> websockify_;
};

} // namespace halftone::display
