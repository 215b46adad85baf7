#pragma once
// What a module of displays gives to the program that loads it. A module is a shared library of its own that
// links what it shows with (SDL2, libvncserver) and this room's headers; it does so alone, so that a program
// that shows nothing loads none of it.
//
//   extern "C" halftone::display::Display* halftone_open_display_2(const char* where) {
//     return new Window(where);
//   }
//
// Program and module are of the same build: classes and exceptions of C++ pass between them. The number in
// the name of the function is that of this interface, and changes with it.

#include <halftone/display/display.h>

namespace halftone::display {

/// What stands behind the name in `--display NAME:WHERE`; "" where nothing does. The display is the caller's,
/// to be deleted. Throws DisplayError, and std::invalid_argument with advice where that cannot be read.
using OpenFunction = Display*(const char* where);

inline constexpr const char* open_function = "halftone_open_display_2";

} // namespace halftone::display

/// Every module defines it, and exports nothing else.
extern "C" __attribute__((visibility("default"))) halftone::display::Display*
halftone_open_display_2(const char* where);
