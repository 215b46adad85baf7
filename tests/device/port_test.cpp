#include <halftone/device/port.h>

#include <halftone/protocol/message.h>

#include <catch2/catch.hpp>

#include <span>

using namespace halftone;
using device::Bytes;
using protocol::Fault;

namespace {

Bytes zoom(std::uint32_t sequence) {
  Bytes bytes;
  append(bytes, protocol::Message{protocol::Opcode::zoom, sequence, {2}, {}});
  return bytes;
}

} // namespace

TEST_CASE("what one client left unfinished is not finished by the next, wherever it was cut") {
  const Bytes whole = zoom(5);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    device::Port port;
    Bytes replies;
    port.receive(std::span(whole).first(size), replies);
    CHECK(port.device.registers.errors == 0);
    port.end(replies);
    INFO("cut off after " << size << " bytes");
    CHECK(port.device.registers.error == Fault::damaged);
    CHECK(port.device.registers.skipped == size);
    port.receive(std::span(whole).subspan(size), replies);
    port.end(replies);
    CHECK(port.device.registers.zoom == 0);
    CHECK(port.device.registers.commands == 0);
    port.receive(whole, replies);
    CHECK(port.device.registers.zoom == 2);
    CHECK(port.device.registers.commands == 1);
  }
}

TEST_CASE("damage at the beginning of a stream comes after no command, whatever the client before sent") {
  device::Port port;
  Bytes replies;
  port.receive(zoom(5), replies);
  port.end(replies);
  port.receive(Bytes{0x6A}, replies);
  port.end(replies);
  CHECK(port.device.registers.error == Fault::damaged);
  CHECK(port.device.registers.error_sequence == 0);
}
