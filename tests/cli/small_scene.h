#pragma once
// A scene that every command can be tried on.

#include <string>

namespace halftone::test {

/// A glass ball, a mirror box and a faceted cone above a floor; quick at 24 x 16.
std::string small_scene(int width = 24, int height = 16, const std::string& transfer = "srgb");

} // namespace halftone::test
