#include "support/messages.h"

#include <halftone/serve/session.h>

#include <halftone/device/snapshot.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace halftone;
using protocol::Message;
using protocol::Opcode;
using test::bytes_of;
using test::whole_read;
using Bytes = std::vector<std::uint8_t>;

namespace {

const Message red_fill{Opcode::fill, 1, {10, 20, 30, 40, 255, 0, 0}, {}};

/// A recording in memory.
struct Tape {
  Bytes bytes;
  recording::Writer writer{
      [this](std::span<const std::uint8_t> more) { bytes.insert(bytes.end(), more.begin(), more.end()); },
      device::Device()};

  device::Device replayed() const {
    const recording::Trace trace = recording::read(bytes, "tape");
    recording::Walk walk(trace);
    while (walk.next()) {
    }
    return walk.device();
  }
};

} // namespace

TEST_CASE("however much a client asks for without listening, the replies that wait are bounded") {
  device::Device device;
  serve::Session session(device, nullptr, "test");
  std::vector<Message> questions(1000, whole_read);
  for (std::size_t i = 0; i < questions.size(); ++i) questions[i].sequence = static_cast<std::uint32_t>(i);
  session.take(bytes_of(questions));
  std::size_t total = 0;
  while (!session.replies().empty()) {
    REQUIRE(session.replies().size() < serve::waiting_limit + test::whole_read_answer);
    const std::size_t part = std::min<std::size_t>(session.replies().size(), 500'000);
    total += part;
    session.replied(part);
  }
  CHECK(session.is_ready());
  CHECK(total == 1000 * test::whole_read_answer);
}

TEST_CASE("a command that a client did not finish is damage, and the picture stays as it was") {
  device::Device device;
  serve::Session session(device, nullptr, "test");
  Bytes bytes = bytes_of({red_fill, {Opcode::fill, 2, {0, 0, 512, 512, 0, 0, 255}, {}}});
  bytes.pop_back();
  session.take(bytes);
  const device::Device before = device;
  session.end("gone");
  CHECK(device.registers.error == protocol::Fault::damaged);
  CHECK(device.registers.skipped > 0);
  CHECK(device.images == before.images);
  CHECK(device.registers.commands == 1);
  CHECK(device.registers.errors == 1);
}

TEST_CASE("the next session to a device begins with a decoder of its own") {
  device::Device device;
  const Bytes fill = bytes_of({red_fill});
  {
    serve::Session session(device, nullptr, "one");
    session.take(std::span(fill).first(10));
    session.end("gone");
  }
  serve::Session session(device, nullptr, "two");
  session.take(fill);
  CHECK(device.registers.commands == 1);
}

TEST_CASE("a device that restarts has forgotten everything, and what was to be answered") {
  device::Device device;
  serve::Session session(device, nullptr, "test");
  session.take(bytes_of({red_fill, whole_read, whole_read, whole_read}));
  session.restart();
  CHECK(session.replies().empty());
  CHECK(session.is_ready());
  device::Device fresh;
  fresh.clock = device.clock;
  CHECK(device == fresh);
  session.take(bytes_of({whole_read}));
  CHECK(session.replies().size() == test::whole_read_answer);
}

TEST_CASE("for a client that does not listen all is executed, and no reply made") {
  device::Device device, heard;
  device.clock.bus = heard.clock.bus = {"slow", 1000, 1'000'000};
  serve::Session session(device, nullptr, "test"), listening(heard, nullptr, "test");
  const Bytes commands = bytes_of({whole_read, whole_read, whole_read, red_fill});
  session.take(commands);
  REQUIRE_FALSE(session.is_ready());
  session.stop_answering();
  CHECK(session.is_ready());
  CHECK(session.replies().empty());
  session.take(commands);
  CHECK(session.is_ready());
  CHECK(session.replies().empty());
  for (int i = 0; i < 2; ++i) {
    listening.take(commands);
    while (!listening.is_ready()) listening.replied(listening.replies().size());
  }
  CHECK(device == heard);
  CHECK(device.registers.commands == 2);
}

TEST_CASE("a client that sends no byte is not in the recording") {
  Tape tape;
  const std::size_t before = tape.bytes.size();
  device::Device device;
  serve::Session session(device, &tape.writer, "test");
  session.take({});
  session.end("gone");
  CHECK(tape.bytes.size() == before);
}

TEST_CASE("a restart is recorded as such, and the client is one again when it goes on") {
  Tape tape;
  device::Device device;
  serve::Session session(device, &tape.writer, "test");
  session.restart();
  session.take(bytes_of({red_fill}));
  session.restart();
  session.restart();
  session.take(bytes_of({red_fill}));
  session.end("gone");
  const recording::Data fill{bytes_of({red_fill})};
  const recording::SessionBegin begin{"test"};
  const recording::SessionEnd lost{"the device restarts"};
  const recording::Restart restart;
  CHECK(recording::read(tape.bytes, "tape").records ==
        std::vector<recording::Record>{restart, begin, fill, lost, restart, restart, begin, fill,
                                       recording::SessionEnd{"gone"}});
  CHECK(device::save(tape.replayed()) == device::save(device));
}

TEST_CASE("a recorded session replays to the device that it left, with damage, restart and unread answers") {
  Tape tape;
  device::Device device;
  const Bytes fill = bytes_of({red_fill}), question = bytes_of({whole_read, whole_read, whole_read});
  for (const bool restarts : {false, true, false}) {
    serve::Session session(device, &tape.writer, "test");
    session.take(fill);
    session.take(bytes_of({{Opcode::pixels, 3, {}, Bytes{1, 2, 3}}}));
    session.take(question);
    if (restarts) session.restart();
    while (!session.is_ready()) session.replied(session.replies().size());
    session.take(std::span(fill).first(15));
    session.end("gone");
    tape.writer.state(device);
  }
  CHECK(device::save(tape.replayed()) == device::save(device));
  const recording::Trace trace = recording::read(tape.bytes, "tape");
  recording::Walk walk(trace, recording::States::compared);
  while (walk.next()) {
  }
  CHECK_FALSE(walk.departure());
}

TEST_CASE("somebody else speaks between a client's commands, as a session of theirs") {
  Tape tape;
  device::Device device;
  serve::Session session(device, &tape.writer, "client");
  const Bytes fill = bytes_of({red_fill}), zoom = bytes_of({{Opcode::zoom, 0, {2}, {}}});
  session.take(std::span(fill).first(5));
  CHECK_FALSE(session.is_interruptible());
  session.take(std::span(fill).subspan(5));
  CHECK(session.is_interruptible());
  session.interrupt(zoom, "console");
  CHECK(device.registers.zoom == 2);
  session.take(fill);
  session.end("done");
  CHECK(device.registers.commands == 3);
  CHECK(device::save(tape.replayed()) == device::save(device));
  const recording::Trace trace = recording::read(tape.bytes, "tape");
  std::vector<std::string> peers;
  for (const auto& record : trace.records)
    if (const auto* begin = std::get_if<recording::SessionBegin>(&record)) peers.push_back(begin->peer);
  CHECK(peers == std::vector<std::string>{"client", "console", "client"});
}

TEST_CASE("the bytes that a client's command lacks are those to its end") {
  device::Device device;
  serve::Session session(device, nullptr, "client");
  const Bytes bytes = bytes_of({red_fill});
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    CAPTURE(i);
    if (i >= 9)
      CHECK(session.missing() == bytes.size() - i); // before, its length is not known
    else
      CHECK((session.missing() != 0) == (i != 0));
    session.take(std::span(bytes).subspan(i, 1));
  }
  CHECK(session.missing() == 0);
  session.take(Bytes(1, 0x5A)); // damage waits to be reported
  CHECK(session.missing() != 0);
}
