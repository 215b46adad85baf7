#include "told.h"

namespace halftone::m508 {

std::string place_of(const inspect::Reference& command) {
  std::string text = "command " + std::to_string(command.number) + " (byte " +
                     std::to_string(command.offset) + ", session " + std::to_string(command.session) +
                     ", sequence " + std::to_string(command.sequence);
  if (!command.section.empty()) text += ", section \"" + command.section + '"';
  return text + ')';
}

std::string of_them(std::uint64_t count, const std::string& name) {
  return std::to_string(count) + ' ' + name + (count == 1 ? "" : "s");
}

nlohmann::ordered_json json_of(const inspect::Reference& command) {
  const nlohmann::ordered_json section =
      command.section.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(command.section);
  return {{"number", command.number},     {"byte", command.offset}, {"session", command.session},
          {"sequence", command.sequence}, {"section", section},     {"text", command.text}};
}

nlohmann::ordered_json json_of(device::Plane plane, const device::Pixel& value) {
  if (plane == device::Plane::overlay) return value[0];
  return nlohmann::ordered_json::array({value[0], value[1], value[2]});
}

nlohmann::ordered_json json_of(const device::Rectangle& area) {
  return nlohmann::ordered_json::array({area.x, area.y, area.width, area.height});
}

} // namespace halftone::m508
