#include <halftone/bus/buses.h>

#include "built_in.h"
#include <halftone/bus/toml_table.h>

#include <halftone/core/error.h>
#include <halftone/terminal/exit_code.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halftone::bus {

namespace {

constexpr const char* advice = "see framebuffer/buses.toml for an example";

/// A number of the table, nothing where it is left out.
std::optional<double> number_of(const toml::table& table, std::string_view key, double least, double most,
                                const std::string& file) {
  const toml::node* node = table.get(key);
  if (node == nullptr) return std::nullopt;
  return number(file, *node, std::string(key), least, most);
}

std::uint64_t picoseconds(double seconds) { return static_cast<std::uint64_t>(std::llround(seconds * 1e12)); }

device::Bus parse_bus(const toml::table& table, const std::string& file) {
  require_known_keys(file, table, "bus", {"name", "bytes_per_second", "microseconds_per_command"});
  const auto* name = table.get_as<std::string>("name");
  if (name == nullptr || name->get().empty() || name->get().size() > 0xFF)
    fail(file, table, "a bus needs a name in quotes, of 1 to 255 bytes", advice);
  const auto rate = number_of(table, "bytes_per_second", 1, 1e12, file);
  const auto command = number_of(table, "microseconds_per_command", 0, 1e6, file);
  return {name->get(), rate ? picoseconds(1 / *rate) : 0, picoseconds(command.value_or(0) * 1e-6)};
}

} // namespace

std::vector<device::Bus> parse_buses(std::string_view toml, const std::string& file) {
  constexpr std::size_t longest = 1 << 16;
  if (toml.size() > longest) throw core::InputError({file}, "is too long for a table of buses", advice);
  const toml::table root = parse_toml(toml, file);
  require_known_keys(file, root, "the file", {"bus"});
  std::vector<device::Bus> buses;
  if (const toml::node* node = root.get("bus")) {
    if (!node->is_array_of_tables()) fail(file, *node, "expected [[bus]] and nothing else", advice);
    for (const toml::node& entry : *node->as_array()) {
      device::Bus bus = parse_bus(*entry.as_table(), file);
      if (std::ranges::any_of(buses, [&](const device::Bus& other) { return other.name == bus.name; }))
        fail(file, entry, "there is a second bus \"" + bus.name + "\"", advice);
      buses.push_back(std::move(bus));
    }
  }
  if (buses.empty()) throw core::InputError({file}, "has no [[bus]]", advice);
  return buses;
}

std::vector<device::Bus> built_in() { return parse_buses(built_in_text, "buses.toml"); }

const device::Bus& find_bus(const std::vector<device::Bus>& buses, const std::string& name) {
  const auto bus = std::ranges::find(buses, name, &device::Bus::name);
  if (bus != buses.end()) return *bus;
  std::string known;
  for (const device::Bus& each : buses) known += (known.empty() ? "" : ", ") + each.name;
  throw terminal::ArgumentError("--bus: unknown bus \"" + name + "\"; known are " + known);
}

} // namespace halftone::bus
