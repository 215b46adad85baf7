#include <halftone/device/snapshot.h>

#include <halftone/protocol/checksum.h>

#include <algorithm>
#include <type_traits>

namespace halftone::device {

namespace {

/// Visits everything that commands can tell apart, in the order of docs/protocol.md.
template<typename Registers, typename Visit>
void visit_settings(Registers& r, Visit& visit) {
  const auto pixel = [&](auto& p) {
    for (auto& channel : p) visit(channel);
  };
  const auto layer = [&](auto& l) {
    visit(l.on);
    visit(l.blink);
    pixel(l.color);
  };
  for (auto* value : {&r.window.x, &r.window.y, &r.window.width, &r.window.height, &r.x, &r.y}) visit(*value);
  visit(r.written);
  visit(r.shown);
  pixel(r.write_mask);
  pixel(r.read_mask);
  visit(r.pan_x);
  visit(r.pan_y);
  visit(r.zoom);
  visit(r.blank);
  visit(r.border);
  pixel(r.border_color);
  layer(r.overlay);
  layer(r.cursor);
  visit(r.cursor_x);
  visit(r.cursor_y);
}

/// The error status and the counters.
template<typename Registers, typename Visit>
void visit_counters(Registers& r, Visit& visit) {
  visit(r.error);
  for (auto* value : {&r.error_sequence, &r.errors, &r.commands, &r.skipped}) visit(*value);
}

template<typename Device, typename VisitBytes>
void visit_memory(Device& device, VisitBytes visit) {
  visit(device.cursor_pattern);
  for (auto& lut : device.luts) visit(lut);
  visit(device.overlay);
  for (auto& image : device.images) visit(image);
}

struct Writer {
  Bytes bytes;

  template<typename T>
  void operator()(const T& value) {
    const auto number = static_cast<std::uint64_t>(value);
    for (std::size_t i = sizeof(T); i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
  }
};

struct Reader {
  std::span<const std::uint8_t> bytes; ///< the caller has seen to it that there are enough
  bool good = true;

  template<typename T>
  void operator()(T& value) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) number = number << 8 | bytes[i];
    bytes = bytes.subspan(sizeof(T));
    if constexpr (std::is_same_v<T, bool>) good = good && number <= 1;
    value = static_cast<T>(number);
  }
};

bool is_on_screen(const Rectangle& r) {
  return r.width >= 1 && r.height >= 1 && r.x + r.width <= protocol::screen_width &&
         r.y + r.height <= protocol::screen_height;
}

bool is_possible(const Registers& r) {
  const Rectangle& w = r.window;
  return is_on_screen(w) && r.x >= w.x && r.x < w.x + w.width && r.y >= w.y && r.y < w.y + w.height &&
         r.written <= 1 && r.shown <= 1 && r.zoom <= 3 && r.pan_x < protocol::screen_width &&
         r.pan_y < protocol::screen_height && r.cursor_x < protocol::screen_width &&
         r.cursor_y < protocol::screen_height &&
         static_cast<std::size_t>(r.error) < protocol::fault_table.size();
}

} // namespace

Bytes save(const Device& device) {
  Writer write;
  visit_settings(device.registers, write);
  visit_counters(device.registers, write);
  write(device.clock.picoseconds);
  visit_memory(device, [&](const auto& memory) {
    write.bytes.insert(write.bytes.end(), memory.begin(), memory.end());
  });
  return std::move(write.bytes);
}

std::optional<Device> restore(std::span<const std::uint8_t> bytes) {
  static const std::size_t snapshot_size = save({}).size();
  if (bytes.size() != snapshot_size) return std::nullopt;
  Device device;
  Reader read{bytes};
  visit_settings(device.registers, read);
  visit_counters(device.registers, read);
  read(device.clock.picoseconds);
  if (!read.good || !is_possible(device.registers)) return std::nullopt;
  visit_memory(device, [&](auto& memory) {
    std::ranges::copy(read.bytes.first(memory.size()), memory.begin());
    read.bytes = read.bytes.subspan(memory.size());
  });
  return device;
}

std::uint32_t state_checksum(const Device& device) {
  Writer write;
  visit_settings(device.registers, write);
  std::uint32_t sum = protocol::checksum(write.bytes);
  visit_memory(device, [&](const auto& memory) { sum = protocol::checksum(memory, sum); });
  return sum;
}

} // namespace halftone::device
