#include "support/messages.h"

#include <halftone/device/device.h>
#include <halftone/file/write.h>
#include <halftone/link/recording_link.h>
#include <halftone/recording/read.h>
#include <halftone/recording/walk.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

using namespace halftone;
using protocol::Opcode;

namespace {

/// A recording on a disk that is full for one of the records, of which it takes nothing.
struct Disk {
  int refused = 0; ///< which call, the header's being the first; 0: none
  int calls = 0;
  recording::Bytes file;

  void append(std::span<const std::uint8_t> bytes) {
    if (++calls == refused) throw file::WriteError("the disk is full");
    file.insert(file.end(), bytes.begin(), bytes.end());
  }
};

/// A device that is told things.
struct Told final : link::Link {
  explicit Told(std::vector<std::uint8_t>& all) : told(all) {}
  void send(std::span<const std::uint8_t> bytes) override {
    told.insert(told.end(), bytes.begin(), bytes.end());
  }
  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override { return 0; }

  std::vector<std::uint8_t>& told;
};

} // namespace

TEST_CASE("a recording on a full disk ends whole and does not contradict itself") {
  const auto first = test::bytes_of({{Opcode::pan, 1, {9, 9}, {}}});
  const auto second =
      test::bytes_of({{Opcode::mark, 2, {}, recording::Bytes{'x'}}, {Opcode::pan, 3, {5, 5}, {}}});
  for (int refused = 0; refused <= 5; ++refused) {
    if (refused == 1 || refused == 2) continue; // before there is a session
    CAPTURE(refused); // 3: the first data, 4: the second, 5: the state after the mark
    Disk disk{refused, 0, {}};
    std::vector<std::uint8_t> told;
    recording::Writer writer([&](std::span<const std::uint8_t> bytes) { disk.append(bytes); },
                             device::Device());
    link::RecordingLink link(std::make_unique<Told>(told), writer, "a test");
    std::vector<std::uint8_t> sent;
    for (const auto& commands : {first, second, first}) {
      try {
        link.send(commands);
        sent.insert(sent.end(), commands.begin(), commands.end());
      } catch (const file::WriteError&) {
        CHECK(refused != 0);
      }
    }
    link.end("so it ended");
    CHECK(told == sent);
    CHECK(sent.size() == (refused == 0 ? 2 * first.size() + second.size() : refused == 3 ? 0 : first.size()));
    const recording::Trace trace = recording::read(disk.file, "r.m508");
    CHECK(trace.cut_off.empty());
    CHECK_FALSE(recording::departure(trace));
    const std::size_t states = refused == 0 ? 1 : 0; // after the session
    REQUIRE(trace.records.size() > states);
    const auto& last = trace.records[trace.records.size() - 1 - states];
    REQUIRE(std::holds_alternative<recording::SessionEnd>(last));
    CHECK(std::get<recording::SessionEnd>(last).how == "so it ended");
  }
}
