#pragma once
// SDL's video, and the X server behind it, which may go away while somebody still looks.

#include <SDL_video.h>

namespace halftone::display {

/// The first of what is SDL's to be made, and the last to go.
class Video {
public:
  /// Throws DisplayError.
  Video();
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// The X server that has this window may go without taking the process along, as Xlib would have it. Where
  /// that cannot be, as before libX11 1.8, or there is no X server, nothing changes.
  void outlive_server_of(SDL_Window* window);

  /// It has gone: nothing of SDL's that has to do with it may be called any more, and nothing be destroyed,
  /// for that waits for a server's answer.
  bool has_lost_server() const { return has_lost_server_; }

private:
  bool has_lost_server_ = false; ///< Xlib's handler sets it
};

} // namespace halftone::display
