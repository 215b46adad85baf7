#pragma once
// Commands for the shell.

#include <string>

namespace halftone::bench {

/// The text as one word that the shell takes as it is.
inline std::string in_shell_quotes(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

} // namespace halftone::bench
