#pragma once
// What a test says where it cannot be made. CI refuses a skip of what it has installed: a display that is not
// found any more would be nobody's failure otherwise.

#include <string>

namespace halftone::test {

/// What was not tested, because something is missing that people can install. Fails the case where the
/// environment has HALFTONE_NO_SKIP, as in .ci/run.
void skip(const std::string& reason);

/// What was not tested, and cannot be asked of every machine: an instruction set, IPv6, a user who is not
/// root, and what .ci/run does not install. Never a failure.
void skip_anywhere(const std::string& reason);

} // namespace halftone::test
