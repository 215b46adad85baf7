#pragma once
// What a person does at a display, as plain values: a display knows keys and the mouse, and neither the
// device nor its protocol; whoever polls it knows those, and no keys.

#include <string>
#include <variant>

namespace halftone::display {

/// Moves what is seen of the image, in pixels of the image: to the right and down, negative numbers to the
/// left and up.
struct Pan {
  int right = 0;
  int down = 0;

  bool operator==(const Pan&) const = default;
};

/// Takes hold of the image at a place of the screen (0 to 511, or beyond where the hand leaves it), or pulls
/// it to one.
struct Drag {
  bool begins = true;
  int x = 0;
  int y = 0;

  bool operator==(const Drag&) const = default;
};

/// Doubles the size of a pixel so many times, or halves it where negative, and keeps what lies at a place of
/// the screen (0 to 511) there.
struct Zoom {
  int steps = 0;
  int x = 256;
  int y = 256;

  bool operator==(const Zoom&) const = default;
};

/// Pan and zoom as at power-on.
struct Home {
  bool operator==(const Home&) const = default;
};

/// What the look-up tables are to make of a picture.
enum class Tables { linear, negative, contours, false_color };

struct SetTables {
  Tables tables = Tables::linear;

  bool operator==(const SetTables&) const = default;
};

/// Shows the other image buffer.
struct OtherBuffer {
  bool operator==(const OtherBuffer&) const = default;
};

/// Shows the overlay plane, or hides it.
struct ToggleOverlay {
  bool operator==(const ToggleOverlay&) const = default;
};

/// Asks what is at a place of the screen (0 to 511), and which command painted it.
struct Probe {
  int x = 0;
  int y = 0;

  bool operator==(const Probe&) const = default;
};

/// No more words about a pixel.
struct EndProbe {
  bool operator==(const EndProbe&) const = default;
};

/// Stops the picture where it is, or lets it go on.
struct Pause {
  bool operator==(const Pause&) const = default;
};

/// So many buses faster, or slower where negative.
struct Pace {
  int steps = 0;

  bool operator==(const Pace&) const = default;
};

/// To another place in the stream, and stops there.
struct Scrub {
  enum class By {
    commands, ///< so many on, back where negative
    share,    ///< such a part of the stream on, back where negative
    place     ///< to this part of the stream, 0 to 1
  };
  By by = By::commands;
  double amount = 0;

  bool operator==(const Scrub&) const = default;
};

/// To what the device shows now, and on with it.
struct Follow {
  bool operator==(const Follow&) const = default;
};

/// Keeps the device's screen as a picture.
struct Screenshot {
  bool operator==(const Screenshot&) const = default;
};

struct Quit {
  bool operator==(const Quit&) const = default;
};

using Event = std::variant<Pan, Drag, Zoom, Home, SetTables, OtherBuffer, ToggleOverlay, Probe, EndProbe,
                           Pause, Pace, Scrub, Follow, Screenshot, Quit>;

} // namespace halftone::display
