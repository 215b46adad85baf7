#include <halftone/inspect/settings.h>

namespace halftone::inspect {

namespace {

using Values = std::vector<std::uint32_t>;

Values values_of(const device::Pixel& pixel) { return {pixel[0], pixel[1], pixel[2]}; }

Values joined(Values first, const Values& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Values values_of(const device::Layer& layer) {
  return joined({layer.on ? 1U : 0U, layer.blink}, values_of(layer.color));
}

} // namespace

std::vector<Setting> settings(const device::Registers& r) {
  return {
      {"window", {r.window.x, r.window.y, r.window.width, r.window.height}},
      {"position", {r.x, r.y}},
      {"write_mask", values_of(r.write_mask)},
      {"written", {r.written}},
      {"shown", {r.shown}},
      {"read_mask", values_of(r.read_mask)},
      {"pan", {r.pan_x, r.pan_y}},
      {"zoom", {r.zoom}},
      {"blank", {r.blank ? 1U : 0U}},
      {"border", joined({r.border}, values_of(r.border_color))},
      {"overlay", values_of(r.overlay)},
      {"cursor", joined({r.cursor_x, r.cursor_y}, values_of(r.cursor))},
      {"error", {static_cast<std::uint32_t>(r.error)}},
      {"error_sequence", {r.error_sequence}},
      {"errors", {r.errors}},
      {"commands", {r.commands}},
      {"skipped", {r.skipped}},
  };
}

std::string text_of(const std::vector<std::uint32_t>& values) {
  std::string text;
  for (const std::uint32_t value : values) text += (text.empty() ? "" : " ") + std::to_string(value);
  return text;
}

} // namespace halftone::inspect
