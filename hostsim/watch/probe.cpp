#include "probe.h"

#include <halftone/inspect/seen.h>

#include <chrono>

namespace halftone::watch {

namespace {

constexpr std::size_t longest_line = 60;

// Work at a time: little beside what a person notices.
constexpr std::chrono::milliseconds slice(8);

std::string cut(std::string line) {
  if (line.size() > longest_line) line.replace(longest_line - 3, std::string::npos, "...");
  return line;
}

std::string color_text(const device::Pixel& color) { return inspect::text_of(device::Plane::image_0, color); }

std::string at(std::uint16_t x, std::uint16_t y) {
  return '(' + std::to_string(x) + ", " + std::to_string(y) + ')';
}

} // namespace

std::vector<std::string> Inquiry::describe(const Player& player, std::uint16_t x, std::uint16_t y) {
  const inspect::Seen seen = inspect::seen_at(player.device(), x, y);
  std::vector<std::string> lines{"screen " + at(x, y) + ": " + color_text(seen.color)};
  if (seen.decider != inspect::Decider::image)
    lines.push_back("the " + std::string(inspect::name_of(seen.decider)) + " lies over the image");
  lines.push_back(std::string(inspect::name_of(seen.source.plane)) + ' ' + at(seen.source.x, seen.source.y) +
                  ": " + color_text(seen.memory));
  if (!search_ || place_ != seen.source || player.position() < position_)
    search_.emplace(player.trace(), seen.source, 0);
  place_ = seen.source;
  is_under_way_ = !search_->go_on(player.position(), std::chrono::steady_clock::now() + slice);
  const inspect::Writers writers = search_->writers();
  position_ = writers.commands;
  if (is_under_way_) {
    lines.emplace_back("looking for who wrote it ...");
    return lines;
  }
  if (!writers.last) {
    lines.emplace_back("no command has written it");
    return lines;
  }
  const inspect::Reference& command = writers.last->command;
  std::string by = "written by command " + std::to_string(command.number) + ", session " +
                   std::to_string(command.session) + ", sequence " + std::to_string(command.sequence);
  if (!command.section.empty()) by += ", " + command.section;
  lines.push_back(cut(by));
  lines.push_back(cut(command.text));
  return lines;
}

} // namespace halftone::watch
