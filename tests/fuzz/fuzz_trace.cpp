// Any file, as it is and with its checksums made right, is refused or read; then it is written as it was,
// survives its text form, and can be walked through.

#include <halftone/protocol/checksum.h>
#include <halftone/recording/read.h>
#include <halftone/recording/text.h>
#include <halftone/recording/walk.h>
#include <halftone/recording/write.h>

#include <algorithm>
#include <cstdlib>
#include <span>

using namespace halftone;
using recording::Bytes;

namespace {

/// Makes the checksum that follows the first `size` bytes right, if there is one. Returns what is behind it.
std::span<std::uint8_t> seal(std::span<std::uint8_t> bytes, std::size_t size) {
  if (bytes.size() < size + 4) return {};
  const std::uint32_t sum = protocol::checksum(bytes.first(size));
  for (std::size_t i = 0; i < 4; ++i) bytes[size + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
  return bytes.subspan(size + 4);
}

std::size_t length_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < 4; ++i) length = length << 8 | bytes[at + i];
  return length;
}

Bytes sealed(Bytes copy) {
  if (copy.size() < 12 || copy.size() < 32U + copy[11]) return copy;
  const std::size_t header = 28U + copy[11];
  for (auto rest = seal(copy, header + 4 + length_at(copy, header)); rest.size() > 5;)
    rest = seal(rest, 5 + length_at(rest, 1));
  return copy;
}

void check(std::span<const std::uint8_t> file) {
  recording::Trace trace;
  try {
    trace = recording::read(file, "fuzz");
  } catch (const recording::TraceError&) {
    return;
  }
  if (!std::ranges::equal(encode(trace), file)) std::abort();
  if (encode(recording::assemble(recording::disassemble(trace))) != encode(trace)) std::abort();
  if (trace.raw || trace.records.empty()) return; // fuzz_device has those, and a device takes a millisecond
  recording::Walk walk(trace);
  while (walk.next()) continue;
}

} // namespace
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  check({bytes, size});
  check(sealed({bytes, bytes + size}));
  return 0;
}
