#pragma once
// The displays that a command is asked for.

#include <halftone/watch/watcher.h>

#include <halftone/display/open.h>

#include <string>
#include <vector>

namespace halftone::watch {

/// As in --display NAME, given any number of times; "none" stands for none. Throws terminal::ArgumentError.
std::vector<display::Choice> parse_displays(const std::vector<std::string>& names);

/// Opens all of them, in order. Throws display::DisplayError, and terminal::ArgumentError for what stands
/// behind a name.
Displays open_displays(const std::vector<display::Choice>& choices);

/// What a player for them has to keep.
Past past_for(const Displays& displays);

/// As in "display vnc on 127.0.0.1:5900"; a line for each that people have to find, its end included.
std::string addresses_of(const std::vector<display::Choice>& choices, const Displays& displays);

} // namespace halftone::watch
