#include "evaluate.h"

#include "explain.h"

#include <halftone/inspect/memory.h>
#include <halftone/inspect/reference.h>

#include <halftone/device/screen.h>
#include <halftone/png/compare.h>
#include <halftone/protocol/checksum.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <variant>

namespace halftone::inspect {

namespace {

using device::Device;
using device::Plane;
using device::Rectangle;

Plane plane_of(Surface surface) {
  if (surface == Surface::overlay) return Plane::overlay;
  return surface == Surface::image_0 ? Plane::image_0 : Plane::image_1;
}

/// The rectangle's pixels in row order, three bytes each.
device::Bytes pixels_of(const Device& device, Surface surface, const Rectangle& area) {
  device::Bytes pixels;
  pixels.reserve(std::size_t{area.width} * area.height * protocol::channels);
  std::array<std::uint8_t, std::size_t{protocol::screen_width} * protocol::channels> row;
  for (std::uint32_t y = area.y; y < std::uint32_t{area.y} + area.height; ++y) {
    if (surface == Surface::screen) device::scan_out(device, y, row);
    for (std::uint32_t x = area.x; x < std::uint32_t{area.x} + area.width; ++x) {
      device::Pixel pixel;
      if (surface == Surface::screen)
        std::copy_n(&row[x * protocol::channels], protocol::channels, pixel.begin());
      else
        pixel = value_at(device,
                         {plane_of(surface), static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
      pixels.insert(pixels.end(), pixel.begin(), pixel.end());
    }
  }
  return pixels;
}

std::string value_text(Surface surface, const device::Pixel& value) {
  return text_of(surface == Surface::overlay ? Plane::overlay : Plane::image_0, value);
}

std::string in_hexadecimal(std::uint32_t number) {
  std::ostringstream text;
  text << "0x" << std::hex;
  text.width(8);
  text.fill('0');
  text << number;
  return text.str();
}

std::string at(std::uint32_t x, std::uint32_t y) {
  return '(' + std::to_string(x) + ", " + std::to_string(y) + ')';
}

Verdict passed() { return {true, {}, {}, {}}; }
Verdict failed(std::string message) { return {false, {}, std::move(message), {}}; }

struct Judge {
  const Device& device;
  const Counts& counts;

  Verdict operator()(const ColorCheck& check) const {
    const device::Bytes pixels = pixels_of(device, check.surface, check.area);
    const std::size_t all = pixels.size() / protocol::channels;
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = all; i-- > 0;) {
      if (std::equal(check.color.begin(), check.color.end(), &pixels[i * protocol::channels])) continue;
      ++wrong;
      first = i;
    }
    if (wrong == 0) return passed();
    device::Pixel found;
    std::copy_n(&pixels[first * protocol::channels], protocol::channels, found.begin());
    std::string message = "pixel " +
                          at(check.area.x + static_cast<std::uint32_t>(first % check.area.width),
                             check.area.y + static_cast<std::uint32_t>(first / check.area.width)) +
                          ": found " + value_text(check.surface, found) + ", expected " +
                          value_text(check.surface, check.color);
    if (all > 1)
      message += "; " + std::to_string(wrong) + " of " + of_them(all, "pixel") + " of " +
                 text_of(check.area) + (wrong == 1 ? " is wrong" : " are wrong");
    return failed(message);
  }

  Verdict operator()(const ChecksumCheck& check) const {
    device::Bytes bytes = pixels_of(device, check.surface, check.area);
    if (check.surface == Surface::overlay) { // a byte a pixel
      for (std::size_t i = 0; i < bytes.size() / protocol::channels; ++i)
        bytes[i] = bytes[i * protocol::channels];
      bytes.resize(bytes.size() / protocol::channels);
    }
    const std::uint32_t found = protocol::checksum(bytes);
    if (found == check.checksum) return passed();
    return failed("checksum of " + text_of(check.area) + ": found " + in_hexadecimal(found) + ", expected " +
                  in_hexadecimal(check.checksum));
  }

  Verdict operator()(const ImageCheck& check) const {
    const png::Picture found{check.area.width, check.area.height,
                             pixels_of(device, check.surface, check.area)};
    const png::Difference difference = png::compare(found, check.picture);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < found.rgb.size(); i += protocol::channels)
      differing +=
          std::equal(&found.rgb[i], &found.rgb[i] + protocol::channels, &check.picture.rgb[i]) ? 0 : 1;
    const double share =
        static_cast<double>(differing) / (static_cast<double>(check.area.width) * check.area.height);

    std::ostringstream message;
    const auto limit = [&](const char* what, double value, const std::optional<double>& most) {
      if (most && value > *most)
        message << (message.str().empty() ? "" : "; ") << what << ' ' << value << " is over " << *most;
    };
    const bool has_limit = check.max_difference || check.max_rmse || check.differing;
    limit("largest difference", difference.largest, has_limit ? check.max_difference : 0.0);
    limit("rmse", difference.rmse, check.max_rmse);
    limit("share of pixels that differ", share, check.differing);
    if (message.str().empty()) return passed();

    const auto x = static_cast<std::size_t>(difference.largest_x),
               y = static_cast<std::size_t>(difference.largest_y);
    const std::size_t i = (y * check.area.width + x) * protocol::channels;
    const auto pixel = [&](const png::Picture& picture) {
      return text_of(Plane::image_0, {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
    };
    message << "; farthest apart is pixel "
            << at(check.area.x + static_cast<std::uint32_t>(x), check.area.y + static_cast<std::uint32_t>(y))
            << ": found " << pixel(found) << ", expected " << pixel(check.picture) << "; " << differing
            << " of " << found.rgb.size() / protocol::channels << " pixels differ";
    Verdict verdict = failed(message.str());
    verdict.difference = png::difference_picture(found, check.picture);
    return verdict;
  }

  Verdict operator()(const SettingsCheck& check) const {
    std::string message;
    const std::vector<Setting> all = settings(device.registers);
    for (const auto& [name, expected] : check.settings) {
      const auto found = std::ranges::find(all, name, &Setting::name);
      if (found != all.end() && found->values == expected) continue;
      message += (message.empty() ? "" : "; ") + name + ": found " +
                 (found == all.end() ? "no such register" : text_of(found->values)) + ", expected " +
                 text_of(expected);
    }
    return message.empty() ? passed() : failed(message);
  }

  Verdict operator()(const CountsCheck& check) const {
    std::string message;
    for (const auto& [name, expected] : check.counts) {
      const auto entry = counts.find(name);
      const std::uint64_t found = entry == counts.end() ? 0 : entry->second;
      if (found != expected)
        message += (message.empty() ? "" : "; ") + name + ": found " + std::to_string(found) + ", expected " +
                   std::to_string(expected);
    }
    return message.empty() ? passed() : failed(message);
  }

  Verdict operator()(const LutCheck& check) const {
    const device::Lut& lut = device.luts[check.channel];
    std::string message;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < check.values.size(); ++i) {
      const std::uint8_t found = lut[check.first + i], expected = check.values[i];
      if (found == expected) continue;
      if (wrong++ == 0)
        message = "entry " + std::to_string(check.first + i) + " of " +
                  std::string(channel_names[check.channel]) + ": found " + std::to_string(found) +
                  ", expected " + std::to_string(expected);
    }
    if (wrong > 1) message += "; " + std::to_string(wrong) + " entries are wrong";
    return wrong == 0 ? passed() : failed(message);
  }
};

} // namespace

void count(const recording::Step& step, Counts& counts) {
  ++counts["commands"];
  if (step.is_restart) return; // no client sent it
  const protocol::Message* message = message_of(step);
  if (message == nullptr) {
    ++counts["errors"];
    return;
  }
  ++counts[std::string(protocol::entry_of(message->opcode).name)];
  if (is_query(*message)) ++counts["queries"];
}

Verdict judge(const Check& check, const Device& device, const Counts& counts) {
  return std::visit(Judge{device, counts}, check.expectation);
}

} // namespace halftone::inspect
