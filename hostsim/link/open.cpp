#include "memory_link.h"

#include <halftone/link/link.h>

#include <array>
#include <string_view>

namespace halftone::link {

namespace {

struct Form {
  std::string_view scheme;
  std::string_view what;
};

constexpr std::array forms_to_come{
    Form{"unix:", "UNIX sockets are"},
    Form{"tcp:", "TCP connections are"},
    Form{"file:", "recordings in a file are"},
    Form{"pipe:", "pipes are"},
};

constexpr std::string_view advice = "use \"mem:\", the device inside this program";

std::invalid_argument refusal(const std::string& address, std::string_view problem) {
  std::string text = "device address \"" + address + "\": ";
  text += problem;
  text += "; ";
  text += advice;
  return std::invalid_argument(text);
}

} // namespace

std::unique_ptr<Link> open(const std::string& address) {
  constexpr std::string_view memory = "mem:";
  if (address == memory) return open_memory_link();
  if (address.starts_with(memory)) throw refusal(address, "nothing may follow \"mem:\"");
  for (const Form& form : forms_to_come) {
    if (address.starts_with(form.scheme))
      throw refusal(address, std::string(form.what) + " not in this build yet");
  }
  throw refusal(address, "not understood");
}

} // namespace halftone::link
