#pragma once
// What --json prints, beside what docs/json.md promises.

#include <set>
#include <string>

namespace halftone::test {

/// All keys of a JSON text, as docs/json.md writes them: rays.eye for a key of a nested object,
/// lights[].color for one of the objects of an array. Arrays of numbers are values, and an empty object is
/// one too.
std::set<std::string> keys_of(const std::string& text);

/// The first column of the table under the heading of docs/json.md.
std::set<std::string> documented(const std::string& heading);

} // namespace halftone::test
