#pragma once
// Reading one table of a scene file: which keys it knows, has and needs.

#include "field.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::scene {

class Table {
public:
  /// Reads the field's value as a table, called what in messages. Refuses a value that is no table, with the
  /// advice, and the first key in the file that is not known. field's file must outlive the table.
  Table(const Field& field, const std::string& what, const std::vector<std::string_view>& known,
        std::string_view advice);
  Table(const Table&) = delete; // fields view its name

  /// The value of a key, if it is there. The field lives as long as the table.
  std::optional<Field> find(std::string_view key) const;

  /// The value of a key that must be there; the example is shown where it is not.
  Field at(std::string_view key, std::string_view example) const;

  /// The table as a whole, for problems of no key in particular.
  Field whole() const { return {value, file, what, what}; }

private:
  const Value& value;
  const std::string_view file;
  const std::string what;
  const Value::Members& members;
};

/// The members of a table whose keys are names, not words of the format.
const Value::Members& members_of(const Field& field, std::string_view advice);

} // namespace halftone::scene
