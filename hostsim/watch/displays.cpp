#include <halftone/watch/displays.h>

#include <halftone/terminal/exit_code.h>

#include <algorithm>
#include <stdexcept>

namespace halftone::watch {

std::vector<display::Choice> parse_displays(const std::vector<std::string>& names) {
  std::vector<display::Choice> choices;
  try {
    for (const std::string& name : names)
      if (name != "none") choices.push_back(display::parse_choice(name));
  } catch (const std::invalid_argument& error) {
    throw terminal::ArgumentError("--display: " + std::string(error.what()));
  }
  if (std::ranges::count(choices, "window", &display::Choice::name) > 1)
    throw terminal::ArgumentError("--display: there is one window, and it was asked for more than once");
  return choices;
}

Displays open_displays(const std::vector<display::Choice>& choices) {
  Displays displays;
  try {
    for (const display::Choice& choice : choices) displays.push_back(open(choice, display::module_folders()));
  } catch (const std::invalid_argument& error) {
    throw terminal::ArgumentError("--display: " + std::string(error.what()));
  }
  return displays;
}

Past past_for(const Displays& displays) {
  return std::ranges::any_of(displays, [](const auto& each) { return each->is_operated(); })
             ? Past::kept
             : Past::forgotten;
}

std::string addresses_of(const std::vector<display::Choice>& choices, const Displays& displays) {
  std::string lines;
  for (std::size_t i = 0; i < displays.size(); ++i)
    if (const std::string address = displays[i]->address(); !address.empty())
      lines += "display " + choices[i].name + " on " + address + '\n';
  return lines;
}

} // namespace halftone::watch
