#include "shown.h"

#include <halftone/bus/buses.h>
#include <halftone/link/address.h>
#include <halftone/link/link.h>
#include <halftone/serve/console.h>
#include <halftone/watch/displays.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <string>
#include <thread>
#include <utility>

#include <sys/eventfd.h>

namespace halftone::m508 {

namespace {

/// The built-in buses and, where it is none of them, this one; from the slowest to the fastest.
std::vector<device::Bus> buses_with(const device::Bus& bus) {
  std::vector<device::Bus> buses = bus::built_in();
  if (std::ranges::find(buses, bus) != buses.end()) return buses;
  std::erase_if(buses, [&](const device::Bus& each) { return each.name == bus.name; });
  buses.insert(
      std::ranges::find_if(
          buses, [&](const device::Bus& each) { return each.byte_picoseconds <= bus.byte_picoseconds; }),
      bus);
  return buses;
}

/// The server in a thread of its own. What ends it is written to `end_`, in every way out of the block.
class Server {
public:
  template<typename Serve>
  Server(const Serve& serve, watch::Tape& tape)
      : thread_([this, serve, &tape] {
          try {
            serve(end_);
          } catch (...) {
            failure_ = std::current_exception();
          }
          is_done_ = true;
          tape.wake();
        }) {}

  ~Server() { ::eventfd_write(end_.number(), 1); }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  bool is_done() const { return is_done_; }

  /// Ends it, and throws what ended it before.
  void finish() {
    ::eventfd_write(end_.number(), 1);
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  file::Descriptor end_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
  std::exception_ptr failure_; ///< to be read when the thread has ended
  std::atomic<bool> is_done_ = false;
  std::jthread thread_; ///< the last: it uses the others
};

} // namespace

void serve_shown(const serve::Listener& listener, device::Device& device, const serve::Settings& settings,
                 recording::Writer& recording, const serve::StopSignals& stop,
                 const watch::Displays& displays, watch::Tape& tape) {
  const std::vector<device::Bus> buses = buses_with(device.clock.bus);
  recording::Trace beginning;
  beginning.header.bus = device.clock.bus;
  watch::Player player(std::move(beginning), recording::Trail::grows, watch::past_for(displays));
  serve::Console console;
  Server server(
      [&](const file::Descriptor& end) {
        serve::serve(listener, device, settings, &recording, end, &console);
      },
      tape);
  const std::string title = "m508 on " + link::name(listener.address());
  watch::Watcher watcher(
      displays, player, tape, buses,
      {[&] { return title; }, [&](const device::Bytes& commands) { console.send(commands); }});
  while (!server.is_done() && !stop.have_come() && watcher.look()) continue;
  server.finish();
}

ShownRecording::ShownRecording(const std::string& title, watch::Player& player, Start start,
                               const watch::Displays& displays)
    : player_(player),
      start_(start),
      buses_(buses_with(player.trace().header.bus)),
      watcher_(displays, player, nothing_more_, buses_, {[title] { return title; }, {}}) {
  const device::Bus& bus = player.trace().header.bus;
  if (start == Start::at_pace)
    watcher_.set_pace(static_cast<std::size_t>(std::ranges::find(buses_, bus) - buses_.begin()));
  if (start == Start::at_end) player.follow();
  if (start == Start::elsewhere) player.pause();
}

bool ShownRecording::look(bool is_busy) {
  if (place_) come_to_place();
  if (is_busy || (place_ && player_.length() < *place_)) nothing_more_.wake();
  return watcher_.look();
}

void ShownRecording::come_to_place() {
  const bool is_there =
      start_ == Start::at_pace ? player_.position() == *place_ : player_.length() >= *place_;
  if (!is_there) return;
  // Who has paused at a place, or gone to one, stays there.
  if (start_ == Start::at_pace ? !player_.is_paused() : player_.is_paused() && player_.position() == 0)
    watcher_.stand_at(*place_);
  player_.hold_at(std::nullopt);
  place_.reset();
}

} // namespace halftone::m508
