// The protocol is RFB (RFC 6143), in which the server tells its pixel format: 32 bits of which each color has
// 8, so that a client that takes it as it is has the device's very bytes. The work is libvncserver's, which
// is under the GPL: this module links it, and nothing else of the program does.

#include "vnc.h"

#include <halftone/display/module.h>

#include <algorithm>
#include <utility>

namespace halftone::display {

namespace {

constexpr std::uint16_t usual_port = 5900;

/// libvncserver tells of every client on stderr, which is the program's.
bool silence() {
  rfbLogEnable(0);
  return true;
}

} // namespace

Vnc::Vnc(std::string_view where) : listener_("vnc", parse_endpoint("vnc", where, usual_port)) {
  // Once in a process: another display's threads may be reading it.
  [[maybe_unused]] static const bool is_silent = silence();
  for (auto& seat : seats_) seat = std::make_unique<Seat>(picture_);
}

void Vnc::show(const Frame& frame) {
  has_picture_ = true;
  if (!picture_.put(frame)) return;
  for (const auto& seat : seats_)
    if (!seat->is_free()) seat->wake();
}

std::vector<Event> Vnc::poll() {
  if (!has_picture_) return {}; // or who comes first would be shown what the device never had
  while (file::Descriptor client = listener_.accept()) take_in(std::move(client));
  return {};
}

/// With all seats taken it is closed at once, as is one that libvncserver's sets of descriptors have no room
/// for.
void Vnc::take_in(file::Descriptor client) {
  const auto seat = std::ranges::find_if(seats_, [](const auto& each) { return each->is_free(); });
  if (seat != seats_.end() && client.number() < FD_SETSIZE) (*seat)->take(std::move(client), title_);
}

} // namespace halftone::display

halftone::display::Display* halftone_open_display_2(const char* where) {
  return new halftone::display::Vnc(where);
}
