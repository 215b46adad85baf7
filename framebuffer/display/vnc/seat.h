#pragma once
// A place for one client of a VNC server.
//
// A client may be slow, or stop in the midst of a message, and libvncserver waits for it: so each has a
// thread, a server of libvncserver's and a copy of the screen of its own, and nobody waits but its own
// thread.

#include "picture.h"
#include <halftone/file/descriptor.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <rfb/rfb.h>

namespace halftone::display {

class Seat {
public:
  /// All seats of a process are made before the first of them is taken: rfbGetScreen initializes a mutex that
  /// all servers of the process share. Throws DisplayError. The picture must outlive the seat.
  explicit Seat(const Picture& picture);
  ~Seat();
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  bool is_free() const { return !is_taken_; }

  /// Serves who is connected there until he goes, under this title. The seat is free.
  void take(file::Descriptor socket, const std::string& title);

  /// The picture has changed.
  void wake() const;

private:
  struct ScreenEnd {
    void operator()(rfbScreenInfo* screen) const { rfbScreenCleanup(screen); }
  };

  void serve(file::Descriptor socket);
  bool wait(int socket) const;

  const Picture& picture_;
  std::unique_ptr<rfbScreenInfo, ScreenEnd> screen_;
  std::vector<std::uint8_t> pixels_; ///< what the client is sent from
  std::string title_;
  file::Descriptor event_;      ///< the picture has changed, or the end has come
  file::Descriptor connection_; ///< the client's socket, under a number that libvncserver does not close
  std::atomic<bool> is_taken_ = false;
  std::atomic<bool> is_ending_ = false;
  std::jthread thread_; ///< the last: it uses the others
};

} // namespace halftone::display
