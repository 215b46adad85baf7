#include "table.h"

#include "suggestion.h"

#include <halftone/core/error.h>

#include <algorithm>

namespace halftone::scene {

const Value::Members& members_of(const Field& field, std::string_view advice) {
  if (const auto* members = std::get_if<Value::Members>(&field.value.content)) return *members;
  refuse(field, "a table", advice);
}

Table::Table(const Field& field, const std::string& what_it_is, const std::vector<std::string_view>& known,
             std::string_view advice)
    : value(field.value),
      file(field.file),
      what(what_it_is),
      members(members_of(field, advice)) {
  for (const Member& member : members)
    if (std::find(known.begin(), known.end(), member.key) == known.end())
      throw core::InputError({std::string(file), member.position.line, member.position.column},
                             "unknown key " + in_quotes(member.key) + " in " + what,
                             did_you_mean(member.key, known, "known keys: " + listed(known)));
}

std::optional<Field> Table::find(std::string_view key) const {
  const auto member =
      std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
  if (member == members.end()) return std::nullopt;
  return Field{member->value, file, what, member->key};
}

Field Table::at(std::string_view key, std::string_view example) const {
  if (const std::optional<Field> field = find(key)) return *field;
  fail(whole(), "missing key " + in_quotes(key) + " in " + what, "add " + std::string(example));
}

} // namespace halftone::scene
