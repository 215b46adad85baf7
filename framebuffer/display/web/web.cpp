#include "web.h"

#include <halftone/display/module.h>
#include <halftone/display/open.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include <sys/socket.h>
#include <sys/time.h>

namespace halftone::display {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::uint16_t usual_port = 6080; // that of noVNC's own scripts
constexpr auto patience = 20s;
constexpr auto pause = 20ms;
constexpr timeval longest_answer{1, 0}; // one second

// Where Debian's package novnc puts it.
constexpr const char* novnc = "/usr/share/novnc";
constexpr const char* page = "/vnc.html";

// Each pixel as it is; whoever wants to see them larger has the browser's own zoom, or noVNC's settings.
constexpr const char* settings = "?autoconnect=true&resize=off&view_only=true";

[[noreturn]] void fail(const std::string& why) { throw DisplayError("display web: " + why); }

/// Whether a browser that asks for the page is given it by now.
bool is_served(const Listener& listener) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getsockname(listener.descriptor().number(), reinterpret_cast<sockaddr*>(&address), &size) != 0)
    return false;
  const file::Descriptor socket(::socket(address.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  ::setsockopt(socket.number(), SOL_SOCKET, SO_RCVTIMEO, &longest_answer, sizeof longest_answer);
  // Also of connect(), which waits where too many have come that nobody has listened to.
  ::setsockopt(socket.number(), SOL_SOCKET, SO_SNDTIMEO, &longest_answer, sizeof longest_answer);
  // An address that stands for all of the machine's leads to the machine.
  if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), size) != 0) return false;
  const std::string question = std::string("GET ") + page + " HTTP/1.0\r\n\r\n";
  if (::send(socket.number(), question.data(), question.size(), MSG_NOSIGNAL) < 0) return false;
  std::array<char, 12> answer{};
  if (::recv(socket.number(), answer.data(), answer.size(), MSG_WAITALL) < 0) return false;
  return std::string_view(answer.data(), answer.size()).ends_with(" 200");
}

} // namespace

Web::Web(std::string_view where) : endpoint_(parse_endpoint("web", where, usual_port)) {
  std::error_code none;
  if (!std::filesystem::exists(std::string(novnc) + page, none))
    fail(std::string(novnc) + page + " is not there; install novnc");
  // websockify is given the socket to listen on, so that a port that is taken is known before it is started,
  // and one that is free is not taken in between.
  const Listener listener("web", endpoint_);
  endpoint_ = listener.endpoint();
  vnc_ = open({"vnc", "127.0.0.1:0"}, module_folders());
  try {
    websockify_.emplace(std::vector<std::string>{"websockify", "--inetd", "--web", novnc, vnc_->address()},
                        listener.descriptor());
  } catch (const std::system_error& error) {
    if (error.code().value() == ENOENT) fail("websockify is not on PATH; install websockify");
    fail("websockify cannot be started: " + std::string(error.what()));
  }
  const auto end = Clock::now() + patience;
  while (!is_served(listener)) {
    if (!websockify_->is_running()) fail("websockify did not start" + reason());
    if (Clock::now() > end) fail("websockify does not answer" + reason());
    std::this_thread::sleep_for(pause);
  }
}

std::string Web::address() const { return "http://" + name(endpoint_) + page + settings; }

std::vector<Event> Web::poll() {
  if (!websockify_->is_running()) fail("websockify has ended" + reason());
  return vnc_->poll();
}

std::string Web::reason() {
  return websockify_->last_words().empty() ? "" : ": " + websockify_->last_words();
}

} // namespace halftone::display

halftone::display::Display* halftone_open_display_2(const char* where) {
  return new halftone::display::Web(where);
}
