#pragma once
// What keys do in the window: one table for the keyboard, the help that the window shows, and
// docs/display.md.

#include <halftone/display/event.h>

#include <SDL_keyboard.h>

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace halftone::display {

/// What is the window's own business.
enum class Own { help, status, full_screen, close_words };

struct Binding {
  SDL_Keycode key = SDLK_UNKNOWN;
  bool shift = false;
  std::variant<Event, Own> action;
};

/// A line of the help; several bindings may share one.
struct Line {
  std::string_view keys;
  std::string_view meaning;
};

/// Nothing for a key that has no meaning.
std::optional<std::variant<Event, Own>> action_of(const SDL_Keysym& key);

const std::vector<Line>& help_lines();

} // namespace halftone::display
