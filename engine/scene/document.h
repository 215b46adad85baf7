#pragma once
// A scene file's TOML as plain values with their places: all that the readers know of TOML.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace halftone::scene {

/// In the file that is being read; both count from 1, columns in code points.
struct Position {
  int line = 1;
  int column = 1;
};

struct Member;

struct Value {
  struct DateOrTime {}; ///< no key of the format wants one, so what it says is dropped

  using Array = std::vector<Value>;
  using Members = std::vector<Member>; ///< of a table, in file order

  Position position; ///< of the value; of the header where a header opens the table
  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Members> content;
};

struct Member {
  std::string key;
  Position position; ///< of the key
  Value value;
};

/// Parses TOML 1.0 text, with or without a byte order mark. Throws core::InputError where it is not TOML, at
/// the parser's place in the file called name. Nesting is bounded, so recursion over the result is safe.
Value parse_document(std::string_view text, const std::string& name);

} // namespace halftone::scene
