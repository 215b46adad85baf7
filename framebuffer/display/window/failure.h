#pragma once
// What SDL could not do, as an exception.

#include <halftone/display/display.h>

#include <SDL_error.h>

#include <string>

namespace halftone::display {

/// Throws DisplayError with SDL's reason.
inline void require(bool success, const std::string& advice = {}) {
  if (!success)
    throw DisplayError("display window: " + std::string(SDL_GetError()) +
                       (advice.empty() ? "" : "; " + advice));
}

} // namespace halftone::display
