#include <halftone/core/error.h>

#include <utility>

namespace halftone::core {

namespace {

std::string message(const Place& place, const std::string& problem, const std::string& advice) {
  std::string text = place.file;
  if (place.line > 0) text += ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
  text += ": " + problem;
  if (!advice.empty()) text += "; " + advice;
  return text;
}

} // namespace

InputError::InputError(Place where, const std::string& problem, const std::string& advice)
    : std::runtime_error(message(where, problem, advice)),
      place(std::move(where)) {}

} // namespace halftone::core
