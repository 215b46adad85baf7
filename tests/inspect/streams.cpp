#include "streams.h"

#include <halftone/protocol/text.h>

namespace halftone::test {

Bytes random_stream(Random& random) {
  Bytes stream;
  for (auto messages = 1 + random() % 24; messages > 0; --messages) {
    const RandomMessage made = random_message(random, protocol::Direction::to_device);
    if (made.message.opcode == protocol::Opcode::reset && random() % 4 != 0) continue;
    append(stream, made.message);
  }
  return stream;
}

recording::Trace trace_of(Bytes stream) {
  recording::Trace trace;
  trace.raw = true;
  trace.records.emplace_back(recording::Data{std::move(stream)});
  return trace;
}

recording::Trace trace_of_text(const std::string& text) { return trace_of(protocol::assemble(text)); }

} // namespace halftone::test
