#include "served.h"

#include "x_server.h"

#include "support/comes_true.h"
#include "support/messages.h"
#include "support/scratch.h"
#include "support/skip.h"

#include <halftone/device/device.h>
#include <halftone/protocol/decoder.h>

#include <catch2/catch.hpp>

#include <filesystem>
#include <span>
#include <variant>

namespace halftone::test {

using namespace std::chrono_literals;
using protocol::Message;
using protocol::Opcode;

bool are_there(const std::vector<std::string>& programs, const std::vector<std::string>& modules,
               const std::string& packages) {
  std::string why = missing(programs);
  for (const std::string& module : modules) {
    const std::string file = "halftone-display-" + module + ".so";
    if (!std::filesystem::exists(std::filesystem::path(HALFTONE_MODULES) / file)) why += ' ' + file;
  }
  if (why.empty()) return true;
  skip("these are not there:" + why + " (Debian: " + packages + ")");
  return false;
}

void send_noise(link::Link& link) {
  std::uint32_t random = 508;
  const auto noise = [&](std::size_t size) {
    device::Bytes bytes(size);
    for (std::uint8_t& byte : bytes)
      byte = static_cast<std::uint8_t>((random = random * 1664525U + 1013904223U) >> 24);
    return bytes;
  };
  for (const std::uint32_t written : {1U, 0U}) {
    link.send(bytes_of({{Opcode::buffers, 1, {written, 0}, {}}, {Opcode::window, 2, {0, 0, 512, 512}, {}}}));
    for (int y = 0; y < 512; ++y) link.send(bytes_of({{Opcode::pixels, 3, {}, noise(1536)}}));
  }
  link.send(bytes_of(
      {{Opcode::overlay, 4, {0, 0, 255, 255, 0}, {}}, {Opcode::overlay_bits, 5, {8, 70}, noise(40)}}));
}

device::Bytes screen_of(link::Link& link) {
  device::Bytes screen;
  link.send(bytes_of({{Opcode::read_screen, 1, {0, 0, 512, 512}, {}}}));
  protocol::Decoder decoder(protocol::Direction::to_host);
  while (screen.size() < device::image_size) {
    std::vector<std::uint8_t> buffer(10000);
    std::span<const std::uint8_t> bytes = std::span(buffer).first(link.receive(buffer, 10s));
    while (const auto item = decoder.next(bytes)) {
      const auto& row = std::get<Message>(item->content);
      screen.insert(screen.end(), row.data.begin(), row.data.end());
    }
  }
  return screen;
}

std::string address_in(const std::string& file, const std::string& display) {
  std::string address;
  comes_true([&] {
    const std::string told = contents(file), before = "display " + display + " on ";
    const std::size_t begin = told.find(before), end = told.find('\n', begin);
    if (begin == std::string::npos || end == std::string::npos) return false;
    address = told.substr(begin + before.size(), end - begin - before.size());
    return true;
  });
  return address;
}

} // namespace halftone::test
