// Decoding a stream of commands: a screen of raw pixels, as many in a command as it can carry, and a stream
// of short commands.

#include "micro.h"

#include <halftone/protocol/decoder.h>
#include <halftone/protocol/message.h>

#include <benchmark/benchmark.h>

namespace halftone::micro {

namespace {

using Stream = std::vector<std::uint8_t>;

Stream pixel_stream() {
  const std::vector<std::uint8_t> pixels(std::size_t{1365} * 3, 0x5A);
  Stream stream;
  for (std::uint32_t command = 0; stream.size() < std::size_t{512} * 512 * 3; ++command)
    protocol::append(stream, {protocol::Opcode::pixels, command, {}, pixels});
  return stream;
}

Stream short_stream() {
  Stream stream;
  for (std::uint32_t command = 0; command < 10'000; ++command)
    protocol::append(stream, {protocol::Opcode::window, command, {0, command % 512, 512, 1}, {}});
  return stream;
}

void time_decoding(benchmark::State& state, const Stream& stream) {
  std::int64_t items = 0;
  for (auto _ : state) {
    protocol::Decoder decoder(protocol::Direction::to_device);
    std::span<const std::uint8_t> bytes = stream;
    while (const auto item = decoder.next(bytes)) {
      if (std::holds_alternative<protocol::Rejection>(item->content))
        state.SkipWithError("a command is refused");
      ++items;
    }
  }
  state.SetItemsProcessed(items);
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(stream.size()));
}

} // namespace

void add_stream() {
  benchmark::RegisterBenchmark("decode/pixels", time_decoding, pixel_stream());
  benchmark::RegisterBenchmark("decode/windows", time_decoding, short_stream());
}

} // namespace halftone::micro
