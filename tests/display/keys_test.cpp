#include "support/scratch.h"

#include "../../framebuffer/display/window/keys.h"

#include <catch2/catch.hpp>

#include <string>

using namespace halftone;

TEST_CASE("docs/display.md has the keys that the window's help has") {
  std::string table = "| | |\n|---|---|\n";
  for (const display::Line& line : display::help_lines())
    table += "| " + std::string(line.keys) + " | " + std::string(line.meaning) + " |\n";
  CAPTURE(table);
  CHECK(test::contents(HALFTONE_SOURCE_DIR "/docs/display.md").find(table + '\n') != std::string::npos);
}

TEST_CASE("keys with Control, Alt or the window manager's are not the window's") {
  SDL_Keysym key{};
  key.sym = SDLK_q;
  CHECK(display::action_of(key).has_value());
  for (const int modifier : {KMOD_LCTRL, KMOD_RALT, KMOD_LGUI, KMOD_LSHIFT}) {
    key.mod = static_cast<Uint16>(modifier);
    CHECK_FALSE(display::action_of(key).has_value());
  }
}
