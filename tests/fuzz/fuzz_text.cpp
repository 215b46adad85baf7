// Any text is refused or assembled, and what it was assembled to survives its text form; so does any stream.

#include "stream.h"

#include <halftone/protocol/text.h>
#include <halftone/recording/text.h>
#include <halftone/recording/write.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <span>
#include <string_view>

using namespace halftone;
using protocol::Direction;

namespace {

constexpr std::size_t largest = 2048; // longer streams show nothing new, slowly

std::optional<recording::Trace> assembled(std::string_view text) {
  try {
    return recording::assemble(text, "fuzz");
  } catch (const protocol::TextError& error) {
    if (error.line < 1 || error.column < 1) std::abort();
    return std::nullopt;
  }
}

void check_stream(std::span<const std::uint8_t> stream, Direction direction) {
  const auto again = protocol::assemble(protocol::disassemble(stream, direction));
  if (!std::ranges::equal(again, stream)) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (const auto trace = assembled({reinterpret_cast<const char*>(bytes), size})) {
    const auto file = encode(*trace);
    if (file.size() > largest) return 0;
    const auto again = assembled(recording::disassemble(*trace));
    if (!again || encode(*again) != file) std::abort();
  }
  check_stream({bytes, size}, Direction::to_host);
  FuzzedDataProvider fuzz(bytes, size);
  auto stream = fuzz::make_stream(fuzz);
  stream.resize(std::min(stream.size(), largest));
  check_stream(stream, Direction::to_device);
  return 0;
}
