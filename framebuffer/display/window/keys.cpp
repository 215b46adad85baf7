#include "keys.h"

#include <algorithm>

namespace halftone::display {

namespace {

constexpr int far = 16; // pixels of the image
constexpr double part = 0.02;

/// Keys by what they are called on the keyboard that is in use, so that + is + wherever it lies.
const std::vector<Binding>& bindings() {
  static const std::vector<Binding> all{
      {SDLK_LEFT, false, Event(Pan{-far, 0})},
      {SDLK_RIGHT, false, Event(Pan{far, 0})},
      {SDLK_UP, false, Event(Pan{0, -far})},
      {SDLK_DOWN, false, Event(Pan{0, far})},
      {SDLK_LEFT, true, Event(Pan{-1, 0})},
      {SDLK_RIGHT, true, Event(Pan{1, 0})},
      {SDLK_UP, true, Event(Pan{0, -1})},
      {SDLK_DOWN, true, Event(Pan{0, 1})},
      {SDLK_PLUS, false, Event(Zoom{1})},
      {SDLK_PLUS, true, Event(Zoom{1})},
      {SDLK_EQUALS, false, Event(Zoom{1})},
      {SDLK_EQUALS, true, Event(Zoom{1})},
      {SDLK_KP_PLUS, false, Event(Zoom{1})},
      {SDLK_MINUS, false, Event(Zoom{-1})},
      {SDLK_KP_MINUS, false, Event(Zoom{-1})},
      {SDLK_0, false, Event(Home{})},
      {SDLK_1, false, Event(SetTables{Tables::linear})},
      {SDLK_2, false, Event(SetTables{Tables::negative})},
      {SDLK_3, false, Event(SetTables{Tables::contours})},
      {SDLK_4, false, Event(SetTables{Tables::false_color})},
      {SDLK_b, false, Event(OtherBuffer{})},
      {SDLK_o, false, Event(ToggleOverlay{})},
      {SDLK_SPACE, false, Event(Pause{})},
      {SDLK_COMMA, false, Event(Scrub{Scrub::By::commands, -1})},
      {SDLK_PERIOD, false, Event(Scrub{Scrub::By::commands, 1})},
      {SDLK_PAGEUP, false, Event(Scrub{Scrub::By::share, -part})},
      {SDLK_PAGEDOWN, false, Event(Scrub{Scrub::By::share, part})},
      {SDLK_HOME, false, Event(Scrub{Scrub::By::place, 0})},
      {SDLK_END, false, Event(Follow{})},
      {SDLK_s, false, Event(Pace{-1})},
      {SDLK_f, false, Event(Pace{1})},
      {SDLK_p, false, Event(Screenshot{})},
      {SDLK_F1, false, Own::help},
      {SDLK_h, false, Own::help},
      {SDLK_i, false, Own::status},
      {SDLK_F11, false, Own::full_screen},
      {SDLK_ESCAPE, false, Own::close_words},
      {SDLK_q, false, Event(Quit{})},
  };
  return all;
}

} // namespace

std::optional<std::variant<Event, Own>> action_of(const SDL_Keysym& key) {
  if ((key.mod & (KMOD_CTRL | KMOD_ALT | KMOD_GUI)) != 0)
    return std::nullopt; // the window manager's, or a terminal's
  const bool shift = (key.mod & KMOD_SHIFT) != 0;
  const auto binding = std::ranges::find_if(
      bindings(), [&](const Binding& each) { return each.key == key.sym && each.shift == shift; });
  if (binding == bindings().end()) return std::nullopt;
  return binding->action;
}

const std::vector<Line>& help_lines() {
  static const std::vector<Line> lines{
      {"arrows", "pan; with Shift one pixel"},
      {"left drag", "pan"},
      {"+ -", "zoom"},
      {"wheel", "zoom where the mouse is"},
      {"0", "neither pan nor zoom"},
      {"1 2 3 4", "tables: linear, negative, contours, false color"},
      {"b", "show the other buffer"},
      {"o", "overlay on or off"},
      {"click", "what is there, and who wrote it"},
      {"Space", "pause, go on"},
      {", .", "one command back, on"},
      {"PgUp PgDn", "2 % of the stream back, on"},
      {"right drag", "to a place in the stream"},
      {"Home", "to its beginning"},
      {"End", "to what is sent now, and on"},
      {"s f", "slower, faster bus of 1985"},
      {"p", "keep the screen as a PNG"},
      {"i", "status line on or off"},
      {"F11", "full screen"},
      {"h F1", "this help"},
      {"Esc", "away with words"},
      {"q", "quit"},
  };
  return lines;
}

} // namespace halftone::display
