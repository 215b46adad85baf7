#include "told.h"

#include <iomanip>
#include <sstream>

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

std::string in_hexadecimal(std::uint32_t number) {
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(8) << number;
  return text.str();
}

std::string text_of(const std::string& file, const recording::Departure& departure) {
  std::string text = file + ": after command " + std::to_string(departure.number) +
                     " this device has state " + in_hexadecimal(departure.checksum) +
                     ", and the recorded one had state " + in_hexadecimal(departure.recorded.checksum) +
                     " after command " + std::to_string(departure.recorded.commands);
  return text + (departure.agreed ? "; they last agreed after command " + std::to_string(*departure.agreed)
                                  : "; no state before it was recorded");
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
