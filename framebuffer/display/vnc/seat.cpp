#include "seat.h"

#include <array>
#include <csignal>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

namespace halftone::display {

namespace {

constexpr int bits = 8;
constexpr int samples = 3;
constexpr int depth = 24;

/// Called before each update: a client that would have its pixels compressed with losses, as browsers ask for
/// unless told otherwise, gets them as they are.
void keep_pixels(rfbClientPtr client) {
  client->tightQualityLevel = -1;
  client->turboQualityLevel = -1;
  if (client->preferredEncoding == rfbEncodingZYWRLE) client->preferredEncoding = rfbEncodingZRLE;
}

/// Keys, the mouse and the clipboard of people who look are none of the device's business.
rfbNewClientAction only_look(rfbClientPtr client) {
  client->viewOnly = TRUE;
  return RFB_CLIENT_ACCEPT;
}

/// Signals are for the thread that the program lets them come to; one that is written to after the other side
/// has gone is an error of write().
void block_signals() {
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

} // namespace

Seat::Seat(const Picture& picture)
    : picture_(picture),
      screen_(rfbGetScreen(nullptr, nullptr, screen_width, screen_height, bits, samples, bytes_a_pixel)),
      event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (screen_ == nullptr || !event_) throw DisplayError("display vnc: out of memory or of file descriptors");
  screen_->serverFormat.depth = depth; // the fourth byte is none of the color
  screen_->cursor = nullptr;           // or it would be drawn into the picture
  screen_->newClientHook = only_look;
  screen_->displayHook = keep_pixels;
  screen_->deferUpdateTime = 0; // frames come at intervals already
}

Seat::~Seat() {
  is_ending_ = true;
  wake();
  if (connection_) ::shutdown(connection_.number(), SHUT_RDWR); // what waits to be written is not waited for
}

void Seat::take(file::Descriptor socket, const std::string& title) {
  title_ = title;
  screen_->desktopName = title_.c_str();
  connection_ = file::Descriptor(::fcntl(socket.number(), F_DUPFD_CLOEXEC, 0));
  is_taken_ = true;
  thread_ = std::jthread([this, own = std::move(socket)]() mutable {
    serve(std::move(own));
    is_taken_ = false;
  });
}

void Seat::wake() const { ::eventfd_write(event_.number(), 1); }

void Seat::serve(file::Descriptor socket) {
  block_signals();
  pixels_.assign(screen_width * screen_height * bytes_a_pixel, 0);
  screen_->frameBuffer = reinterpret_cast<char*>(pixels_.data());
  std::uint64_t seen = 0;
  picture_.update(pixels_, seen);
  rfbNewClient(screen_.get(), socket.release()); // closes it, whatever comes of it
  while (const rfbClientRec* client = screen_->clientHead) {
    if (!wait(client->sock) || is_ending_) rfbCloseClient(screen_->clientHead);
    for (const Rows& rows : picture_.update(pixels_, seen))
      rfbMarkRectAsModified(screen_.get(), 0, rows.first, screen_width, rows.first + rows.count);
    rfbProcessEvents(screen_.get(), 0); // also forgets a client that has gone
  }
}

/// Until the client says something or the picture has changed; false where that cannot be.
bool Seat::wait(int socket) const {
  std::array<pollfd, 2> entries{pollfd{socket, POLLIN, 0}, pollfd{event_.number(), POLLIN, 0}};
  constexpr int without_end = -1;
  if (::poll(entries.data(), entries.size(), without_end) < 0) return false;
  eventfd_t count = 0;
  ::eventfd_read(event_.number(), &count);
  return true;
}

} // namespace halftone::display
