#include "rfb_client.h"

#include <halftone/link/address.h>
#include <halftone/link/socket.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

namespace halftone::test {

using namespace std::chrono_literals;

RfbClient::RfbClient(const std::string& address, std::function<void()> serve)
    : socket_(link::connect(std::get<link::TcpAddress>(link::parse_address("tcp:" + address)), 5s)),
      serve_(std::move(serve)),
      rgb_(static_cast<std::size_t>(512 * 512 * 3)) {}

void RfbClient::shake_hands() {
  const std::vector<std::uint8_t> version = take(12);
  REQUIRE(std::string(version.begin(), version.end()) == "RFB 003.008\n");
  send("RFB 003.008\n");
  const std::vector<std::uint8_t> kinds = take(number(1));
  REQUIRE(std::ranges::find(kinds, 1) != kinds.end()); // no password
  send("\1");
  REQUIRE(number(4) == 0);
  send("\1");
  REQUIRE(number(2) == 512);
  REQUIRE(number(2) == 512);
  // 32 bits, 24 of them colors, in the order of a PC's bytes; red, green and blue to 255 in the first three
  // bytes.
  std::vector<std::uint8_t> format = take(16);
  REQUIRE(format[3] != 0); // true color
  format[3] = 1;
  REQUIRE(format == std::vector<std::uint8_t>{32, 24, 0, 1, 0, 255, 0, 255, 0, 255, 0, 8, 16, 0, 0, 0});
  const std::vector<std::uint8_t> title = take(number(4));
  title_.assign(title.begin(), title.end());
  send(std::string_view("\2\0\0\1\0\0\0\0", 8)); // encodings: raw
}

void RfbClient::ask(bool is_incremental) {
  send(std::string("\3") + (is_incremental ? '\1' : '\0') + std::string("\0\0\0\0\2\0\2\0", 8));
}

std::vector<RfbClient::Rectangle> RfbClient::take_update() {
  REQUIRE(number(1) == 0);
  take(1); // of no meaning
  std::vector<Rectangle> rectangles(number(2));
  for (Rectangle& rectangle : rectangles) {
    for (int* side : {&rectangle.x, &rectangle.y, &rectangle.width, &rectangle.height})
      *side = static_cast<int>(number(2));
    REQUIRE(number(4) == 0); // raw
    const std::vector<std::uint8_t> pixels =
        take(static_cast<std::size_t>(rectangle.width * rectangle.height * 4));
    auto pixel = pixels.begin();
    for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y)
      for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x, pixel += 4)
        std::copy_n(pixel, 3, rgb_.begin() + 3 * (512 * y + x));
  }
  return rectangles;
}

void RfbClient::send(std::string_view bytes) const {
  REQUIRE(::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
          static_cast<ssize_t>(bytes.size()));
}

bool RfbClient::hears_something(int milliseconds) const {
  pollfd entry{socket_.number(), POLLIN, 0};
  return ::poll(&entry, 1, milliseconds) == 1;
}

bool RfbClient::is_closed() {
  std::uint8_t byte = 0;
  return hears_something(0) && ::recv(socket_.number(), &byte, 1, MSG_PEEK) <= 0;
}

std::vector<std::uint8_t> RfbClient::take(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  const auto end = std::chrono::steady_clock::now() + 15s;
  for (std::size_t there = 0; there < count;) {
    REQUIRE(std::chrono::steady_clock::now() < end);
    serve_();
    if (!hears_something(5)) continue;
    const ssize_t more = ::recv(socket_.number(), &bytes[there], count - there, 0);
    REQUIRE(more > 0);
    there += static_cast<std::size_t>(more);
  }
  return bytes;
}

/// Big-endian.
std::uint32_t RfbClient::number(std::size_t bytes) {
  std::uint32_t number = 0;
  for (const std::uint8_t byte : take(bytes)) number = number << 8 | byte;
  return number;
}

} // namespace halftone::test
