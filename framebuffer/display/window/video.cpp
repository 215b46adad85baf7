// Where the connection to an X server breaks, Xlib calls a handler, and then another that must not return but
// ends the process: what was to be written at the end would be lost. Since libX11 1.8 (2022) the second one
// may be replaced, for a connection, by one that returns: every call from then on fails at once, which is
// enough to get away. It is looked for while the program runs, as it may be older than the one we were built
// with.

#include "video.h"

#include "failure.h"

#include <SDL.h>
#include <SDL_syswm.h>

#include <cstdlib>
#include <string_view>

#include <dlfcn.h>

namespace halftone::display {

namespace {

constexpr const char* unreachable = "the desktop that DISPLAY or WAYLAND_DISPLAY names cannot be reached";

} // namespace

Video::Video() {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); // they are the program's
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  SDL_SetHint(SDL_HINT_VIDEO_X11_NET_WM_BYPASS_COMPOSITOR, "0");
  SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
  // Otherwise what the software renderer has drawn goes to the window as a texture of OpenGL.
  SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
  // Asked before SDL is, whose libraries would complain on stderr.
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    throw DisplayError("display window: there is no desktop: neither DISPLAY nor WAYLAND_DISPLAY is set");
  require(SDL_InitSubSystem(SDL_INIT_VIDEO) == 0, unreachable);
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  // What SDL takes where there is nothing that people could see.
  if (driver == "dummy" || driver == "offscreen" || driver == "evdev") {
    SDL_QuitSubSystem(SDL_INIT_VIDEO);
    throw DisplayError("display window: " + std::string(unreachable));
  }
}

Video::~Video() {
  if (!has_lost_server_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

#ifdef SDL_VIDEO_DRIVER_X11

namespace {

using ExitHandler = void(::Display*, void*);
using SetExitHandler = void(::Display*, ExitHandler*, void*);
using Handler = int(::Display*);
using SetHandler = Handler*(Handler*);

void remember(::Display*, void* is_lost) { *static_cast<bool*>(is_lost) = true; }

/// Xlib's own complains on stderr, which is the program's.
int say_nothing(::Display*) { return 0; }

} // namespace

void Video::outlive_server_of(SDL_Window* window) {
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info) != SDL_TRUE || info.subsystem != SDL_SYSWM_X11) return;
  void* const xlib = ::dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
  if (xlib == nullptr) return;
  auto* const set_exit_handler = reinterpret_cast<SetExitHandler*>(::dlsym(xlib, "XSetIOErrorExitHandler"));
  auto* const set_handler = reinterpret_cast<SetHandler*>(::dlsym(xlib, "XSetIOErrorHandler"));
  if (set_exit_handler == nullptr || set_handler == nullptr) return;
  set_exit_handler(info.info.x11.display, remember, &has_lost_server_);
  set_handler(say_nothing);
}

#else

void Video::outlive_server_of(SDL_Window*) {}

#endif

} // namespace halftone::display
