#pragma once
// The one exception that input can cause. Broken contracts are assertions, geometric emptiness is a value.

#include <stdexcept>
#include <string>

namespace halftone::core {

/// A place in an input file. Lines and columns count from 1; 0 means "the file as a whole".
struct Place {
  std::string file;
  int line = 0;
  int column = 0;
};

/// Thrown where input cannot be read or is wrong. what() is one line without a trailing newline:
///   scenes/x.toml:12:7: unknown key "raduis" in sphere; did you mean "radius"?
class InputError : public std::runtime_error {
public:
  /// problem says what was found and expected, advice what to do about it (may be empty).
  InputError(Place place, const std::string& problem, const std::string& advice = {});

  Place place;
};

} // namespace halftone::core
