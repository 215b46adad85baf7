#pragma once
// What clients of the tests do.

#include "support/messages.h"
#include "support/scratch.h"

#include <halftone/link/link.h>
#include <halftone/link/socket.h>
#include <halftone/protocol/decoder.h>

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace halftone::test {

/// Every kind of address that a server can have, in this folder.
inline std::vector<std::string> places(const Scratch& scratch) {
  return {"unix:" + scratch / "s", "tcp:127.0.0.1:0"};
}

/// A bare socket, for what no link does.
inline file::Descriptor connect(const link::Address& address) {
  const std::chrono::seconds timeout(5);
  const auto* tcp = std::get_if<link::TcpAddress>(&address);
  return tcp != nullptr ? link::connect(*tcp, timeout)
                        : link::connect(std::get<link::UnixAddress>(address), timeout);
}

/// Hands the answer to a query that has one to `take`.
template<typename Take>
void ask(link::Link& link, const protocol::Message& query, std::chrono::milliseconds timeout,
         const Take& take) {
  link.send(bytes_of({query}));
  protocol::Decoder decoder(protocol::Direction::to_host);
  while (true) {
    std::vector<std::uint8_t> buffer(1000);
    std::span<const std::uint8_t> bytes = std::span(buffer).first(link.receive(buffer, timeout));
    if (const auto item = decoder.next(bytes)) return take(std::get<protocol::Message>(item->content));
  }
}

/// The operands of the answer.
inline auto ask(link::Link& link, const protocol::Message& query,
                std::chrono::milliseconds timeout = std::chrono::seconds(5)) {
  decltype(protocol::Message::operands) operands{};
  ask(link, query, timeout, [&](const protocol::Message& answer) { operands = answer.operands; });
  return operands;
}

inline std::uint32_t color_at_origin(link::Link& link) {
  std::uint32_t color = 0;
  ask(link, {protocol::Opcode::read, 9, {0, 0, 1, 1}, {}}, std::chrono::seconds(10),
      [&](const protocol::Message& row) { color = row.data[0] * 65536U + row.data[1] * 256U + row.data[2]; });
  return color;
}

} // namespace halftone::test
