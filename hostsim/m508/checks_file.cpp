#include "checks_file.h"

#include "input.h"

#include <halftone/bus/toml_table.h>
#include <halftone/core/error.h>
#include <halftone/inspect/memory.h>

#include <halftone/protocol/operand.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

namespace halftone::m508 {

namespace {

using bus::fail;
using bus::integer;
using bus::integers;
using bus::number;
using bus::parse_toml;
using bus::require_known_keys;
using bus::text;

using inspect::Check;
using inspect::Surface;
using protocol::screen_height;
using protocol::screen_width;

constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max();

/// One [[check]] table. Every function takes a key that is there.
class CheckReader {
public:
  CheckReader(const std::filesystem::path& file, const toml::table& table)
      : file_(file.string()),
        folder_(file.parent_path()),
        table_(table) {}

  /// What its image was read from.
  std::optional<std::string> picture() const {
    if (!has("image")) return std::nullopt;
    return (folder_ / text(file_, at("image"), "image")).string();
  }

  Check read(std::size_t number) const {
    require_known_keys(file_, table_, "check",
                       {"name", "at", "plane", "pixel", "rectangle", "color", "checksum", "image",
                        "max_difference", "max_rmse", "differing", "registers", "counts", "lut"});
    const std::string_view expectation =
        the_one_of({"color", "checksum", "image", "registers", "counts", "lut"});
    Check check;
    check.name = has("name") ? name() : "check " + std::to_string(number);
    check.at = moment();
    forbid_strangers(expectation);
    if (expectation == "color")
      check.expectation = color();
    else if (expectation == "checksum")
      check.expectation =
          inspect::ChecksumCheck{surface(), area(), integer(file_, at("checksum"), "checksum", 0, any)};
    else if (expectation == "image")
      check.expectation = image();
    else if (expectation == "registers")
      check.expectation = registers();
    else if (expectation == "counts")
      check.expectation = counts();
    else
      check.expectation = lut();
    return check;
  }

private:
  bool has(std::string_view key) const { return table_.contains(key); }
  const toml::node& at(std::string_view key) const { return *table_.get(key); }

  std::string_view the_one_of(const std::vector<std::string_view>& keys) const {
    std::string_view found;
    std::string names;
    for (const std::string_view key : keys) {
      names += (names.empty() ? "" : ", ") + std::string(key);
      if (!has(key)) continue;
      if (!found.empty())
        fail(file_, at(key), "a check with both " + std::string(found) + " and " + std::string(key),
             "make two checks of it");
      found = key;
    }
    if (found.empty()) fail(file_, table_, "a check that expects nothing", "it needs one of " + names);
    return found;
  }

  /// Keys that mean nothing beside this expectation.
  void forbid_strangers(std::string_view expectation) const {
    const bool is_of_pixels = expectation == "color" || expectation == "checksum" || expectation == "image";
    for (const std::string_view key : {"plane", "pixel", "rectangle"})
      if (has(key) && !is_of_pixels)
        fail(file_, at(key), std::string(key) + " means nothing beside " + std::string(expectation),
             "leave it out");
    for (const std::string_view key : {"max_difference", "max_rmse", "differing"})
      if (has(key) && expectation != "image")
        fail(file_, at(key), std::string(key) + " means nothing without image", "leave it out");
    if (has("pixel") && has("rectangle"))
      fail(file_, at("rectangle"), "a check with both pixel and rectangle", "make two checks of it");
  }

  /// Control characters would break the line of a check, and XML has no place for them.
  std::string name() const {
    const std::string name = text(file_, at("name"), "name");
    for (std::size_t i = 0; i < name.size(); ++i)
      if (const auto c = static_cast<unsigned char>(name[i]); c < 0x20 || c == 0x7F)
        fail(file_, at("name"),
             "name: character " + std::to_string(i + 1) + " is a control character, of code " +
                 std::to_string(c),
             "use letters, digits, blanks and signs");
    return name;
  }

  inspect::Moment moment() const {
    if (!has("at")) return inspect::AtEnd{};
    const toml::node& node = at("at");
    if (node.is_integer()) return std::uint64_t{integer(file_, node, "at", 0, any)};
    if (!node.is_string())
      fail(file_, node, "at: expected \"end\", the number of a command or the name of a mark");
    const std::string name = text(file_, node, "at");
    if (name == "end") return inspect::AtEnd{};
    return name;
  }

  Surface surface() const {
    if (!has("plane")) return Surface::screen;
    const std::string name = text(file_, at("plane"), "plane");
    constexpr std::array<std::string_view, 4> names{"screen", "image0", "image1", "overlay"};
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      fail(file_, at("plane"), "unknown plane \"" + name + '"', "it is screen, image0, image1 or overlay");
    return static_cast<Surface>(found - names.begin());
  }

  /// The whole surface unless told otherwise.
  device::Rectangle area() const {
    const auto narrow = [](std::uint32_t value) { return static_cast<std::uint16_t>(value); };
    if (has("pixel")) {
      const auto p = integers(file_, at("pixel"), "pixel", {0, 0}, {screen_width - 1, screen_height - 1});
      return {narrow(p[0]), narrow(p[1]), 1, 1};
    }
    if (!has("rectangle")) return {};
    const auto r = integers(file_, at("rectangle"), "rectangle [x, y, width, height]", {0, 0, 1, 1},
                            {screen_width - 1, screen_height - 1, screen_width, screen_height});
    if (r[0] + r[2] > screen_width || r[1] + r[3] > screen_height)
      fail(file_, at("rectangle"), "the rectangle reaches beyond the screen of 512 x 512",
           "it is [x, y, width, height]");
    return {narrow(r[0]), narrow(r[1]), narrow(r[2]), narrow(r[3])};
  }

  inspect::ColorCheck color() const {
    const Surface on = surface();
    if (!has("pixel") && !has("rectangle"))
      fail(file_, table_, "a check of a color needs pixel or rectangle", "as in pixel = [10, 20]");
    if (on == Surface::overlay) {
      const auto bit = static_cast<std::uint8_t>(integer(file_, at("color"), "color of the overlay", 0, 1));
      return {on, area(), {bit, bit, bit}};
    }
    const auto c = integers(file_, at("color"), "color", {0, 0, 0}, {255, 255, 255});
    const auto narrow = [](std::uint32_t value) { return static_cast<std::uint8_t>(value); };
    return {on, area(), {narrow(c[0]), narrow(c[1]), narrow(c[2])}};
  }

  inspect::ImageCheck image() const {
    inspect::ImageCheck check{surface(), area(), {}, {}, {}, {}};
    if (check.surface == Surface::overlay)
      fail(file_, at("plane"), "the overlay is no picture", "check it by color or checksum");
    check.picture = png::read(*picture());
    if (check.picture.width != check.area.width || check.picture.height != check.area.height)
      fail(file_, at("image"),
           "the image has " + std::to_string(check.picture.width) + " x " +
               std::to_string(check.picture.height) + " pixels, and what it is compared with " +
               std::to_string(check.area.width) + " x " + std::to_string(check.area.height),
           "say where it lies, as in rectangle = [x, y, " + std::to_string(check.picture.width) + ", " +
               std::to_string(check.picture.height) + "]");
    const auto limit = [&](std::string_view key, double most) -> std::optional<double> {
      if (!has(key)) return std::nullopt;
      return number(file_, at(key), std::string(key), 0, most);
    };
    check.max_difference = limit("max_difference", 255);
    check.max_rmse = limit("max_rmse", 255);
    check.differing = limit("differing", 1);
    return check;
  }

  /// The members of a table, of which there are some, in the order of the file.
  std::vector<std::pair<std::string, const toml::node*>> members(std::string_view key) const {
    const auto* table = at(key).as_table();
    if (table == nullptr)
      fail(file_, at(key), std::string(key) + ": expected a table",
           "as in " + std::string(key) + " = { errors = 0 }");
    if (table->empty())
      fail(file_, at(key), std::string(key) + ": an empty table holds whatever the recording does",
           "say what is expected, as in " + std::string(key) + " = { errors = 0 }");
    std::vector<std::pair<std::string, const toml::node*>> all;
    for (const auto& [name, node] : *table) all.emplace_back(name.str(), &node);
    std::ranges::sort(all, {}, [](const auto& member) {
      const auto& begin = member.second->source().begin;
      return std::pair(begin.line, begin.column);
    });
    return all;
  }

  inspect::SettingsCheck registers() const {
    inspect::SettingsCheck check;
    for (const auto& [name, node] : members("registers")) {
      const auto count = inspect::numbers_of_setting(name);
      if (!count) {
        std::string names;
        for (const inspect::Setting& setting : inspect::settings({}))
          names += (names.empty() ? "" : ", ") + std::string(setting.name);
        fail(file_, *node, "unknown register \"" + name + '"', "the registers are " + names);
      }
      if (*count == 1)
        check.settings.emplace_back(name, std::vector{integer(file_, *node, name, 0, any)});
      else
        check.settings.emplace_back(
            name, integers(file_, *node, name, std::vector(*count, 0U), std::vector(*count, any)));
    }
    return check;
  }

  inspect::CountsCheck counts() const {
    inspect::CountsCheck check;
    for (const auto& [name, node] : members("counts")) {
      if (!inspect::is_counted(name))
        fail(file_, *node, "unknown count \"" + name + '"',
             "commands, queries, errors and the opcodes of docs/protocol.md are counted");
      check.counts.emplace_back(name, integer(file_, *node, name, 0, any));
    }
    return check;
  }

  inspect::LutCheck lut() const {
    inspect::LutCheck check;
    const auto* table = at("lut").as_table();
    const std::string example = "as in lut = { channel = \"red\", first = 0, values = [0, 1, 2] }";
    if (table == nullptr) fail(file_, at("lut"), "lut: expected a table", example);
    require_known_keys(file_, *table, "lut", {"channel", "first", "values"});
    if (!table->contains("channel") || !table->contains("values"))
      fail(file_, *table, "a lut needs channel and values", example);
    const toml::node& channel = *table->get("channel");
    const auto found = std::ranges::find(inspect::channel_names, text(file_, channel, "channel"));
    if (found == inspect::channel_names.end())
      fail(file_, channel, "unknown channel", "it is red, green or blue");
    check.channel = static_cast<std::size_t>(found - inspect::channel_names.begin());
    if (const toml::node* first = table->get("first")) check.first = integer(file_, *first, "first", 0, 255);
    const toml::node& values = *table->get("values");
    const std::size_t count = values.is_array() ? values.as_array()->size() : 0;
    if (count == 0 || check.first + count > 256)
      fail(file_, values,
           "values: expected an array of 1 to " + std::to_string(256 - check.first) + " integers", example);
    for (const std::uint32_t value :
         integers(file_, values, "values", std::vector(count, 0U), std::vector(count, 255U)))
      check.values.push_back(static_cast<std::uint8_t>(value));
    return check;
  }

  std::string file_;
  std::filesystem::path folder_;
  const toml::table& table_;
};

} // namespace

ChecksFile read_checks(const std::filesystem::path& file) {
  const std::string name = file.string();
  const toml::table root = parse_toml(read_text(name), name);
  require_known_keys(name, root, "the file", {"check"});
  const auto* array = root.get_as<toml::array>("check");
  if (array == nullptr || array->empty())
    throw core::InputError({name}, "there is no check in it", "begin one with [[check]]");
  ChecksFile all;
  std::set<std::string> names;
  for (const toml::node& node : *array) {
    const auto* table = node.as_table();
    if (table == nullptr) fail(name, node, "expected a table", "begin a check with [[check]]");
    const CheckReader reader(file, *table);
    all.checks.push_back(reader.read(all.checks.size() + 1));
    if (const auto picture = reader.picture()) all.pictures.push_back(*picture);
    if (!names.insert(all.checks.back().name).second)
      fail(name, *table, "a second check \"" + all.checks.back().name + '"', "give each a name of its own");
  }
  return all;
}

} // namespace halftone::m508
