#include "random_trace.h"

#include <halftone/device/port.h>
#include <halftone/recording/write.h>

#include <algorithm>
#include <string>

namespace halftone::test {

namespace {

std::string random_text(Random& random) {
  std::string text(random() % 20, ' ');
  for (char& c : text) c = static_cast<char>(random() % 8 == 0 ? random() : between(random, ' ', '~'));
  return text;
}

void add_session(Random& random, std::vector<recording::Record>& records) {
  if (random() % 8 != 0) records.emplace_back(recording::SessionBegin{random_text(random)});
  const auto stream = random_stream(random, protocol::Direction::to_device);
  for (std::span<const std::uint8_t> rest = stream; !rest.empty();) {
    const std::size_t size = std::min<std::size_t>(rest.size(), random() % (random() % 2 == 0 ? 30 : 3000));
    records.emplace_back(recording::Data{{rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(size)}});
    if (random() % 8 == 0)
      records.emplace_back(recording::State{random(), static_cast<std::uint32_t>(random())});
    rest = rest.subspan(size);
  }
  if (random() % 8 != 0) records.emplace_back(recording::SessionEnd{random_text(random)});
}

} // namespace

recording::Trace random_trace(Random& random) {
  recording::Trace trace;
  trace.header.bus = {random_text(random), random(), random()};
  if (random() % 4 == 0) {
    device::Port port;
    device::Bytes replies;
    port.receive(random_stream(random, protocol::Direction::to_device), replies);
    trace.header.snapshot = recording::pack_state(port.device);
  }
  for (auto sessions = random() % 4; sessions > 0; --sessions) {
    if (random() % 4 == 0) trace.records.emplace_back(recording::Restart{});
    add_session(random, trace.records);
  }
  if (random() % 4 == 0) {
    trace.cut_off = encode(recording::Record{recording::SessionEnd{"an end that was cut off"}});
    trace.cut_off.resize(1 + random() % (trace.cut_off.size() - 1));
  }
  return trace;
}

} // namespace halftone::test
