#pragma once
// Where a person sees the device's screen: a window, a VNC server, a browser. Each is a module (module.h)
// that is loaded when somebody asks for it (open.h).
//
// A display has no thread that anybody else sees: it is made, called and destroyed by one thread, the one
// that opened it, which polls it about a hundred times a second. No call waits for a person, for a client or
// for the next field. Where a module needs a thread or a process, it ends with the display.

#include <halftone/display/event.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace halftone::display {

inline constexpr int screen_width = 512;  ///< pixels
inline constexpr int screen_height = 512; ///< rows

/// Rows of the screen, from the top: 0 <= first, first + count <= 512.
struct Rows {
  int first = 0;
  int count = 0;

  bool operator==(const Rows&) const = default;
};

/// The device's screen as it is scanned out. The pixels are the caller's, and good during the call.
struct Frame {
  std::span<const std::uint8_t> rgb; ///< 512 x 512 pixels of 3 bytes, rows from the top
  Rows changed;                      ///< since the last frame: at least one row; at first all of them
};

/// What there is to say beside the picture. A display that has no room for it says nothing.
struct Words {
  std::string title;  ///< who is being watched, and how far it is
  std::string status; ///< pause, pace, a place in the stream; empty where the device is simply followed
  double place = 1;   ///< in the stream, 0 to 1, where there is a status
  std::vector<std::string> probed; ///< about a pixel; empty where none was asked about

  bool operator==(const Words&) const = default;
};

/// The display cannot be had, or has gone. what() is one line with advice.
class DisplayError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Display {
public:
  virtual ~Display() = default;

  /// Where people find it, as in "http://127.0.0.1:6080/vnc.html"; empty where they see it before them.
  virtual std::string address() const { return {}; }

  /// Whether people do anything there, or only look: poll() then gives no events.
  virtual bool is_operated() const { return false; }

  /// The screen has changed. What is shown after it is the whole frame. Throws DisplayError, as the others
  /// do.
  virtual void show(const Frame& frame) = 0;

  /// The words have changed.
  virtual void say(const Words& words) = 0;

  /// What people have done since the last time, in order. Also lets the display do its own work: redraw what
  /// was uncovered, take in new clients.
  virtual std::vector<Event> poll() = 0;
};

} // namespace halftone::display
