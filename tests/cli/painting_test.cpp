// What halftone view does without a window: one thread draws and sends, another looks and presses keys.

#include "../../hostsim/cli/painting.h"

#include "../link/peer.h"
#include "../watch/fake_display.h"
#include "small_scene.h"
#include "support/scratch.h"

#include <halftone/bus/buses.h>
#include <halftone/device/screen.h>
#include <halftone/file/write.h>
#include <halftone/link/recording_link.h>
#include <halftone/link/shared_link.h>
#include <halftone/recording/write.h>
#include <halftone/watch/player.h>
#include <halftone/watch/tape.h>
#include <halftone/watch/watcher.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace halftone;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

const render::Settings settings{.threads = 2};

/// A scene that is painted on an emulated device, watched, and operated.
struct Viewed {
  /// Looks, and pans, until the title has these words.
  bool comes_to(const std::string& words) {
    const auto end = Clock::now() + 30s;
    while (Clock::now() < end) {
      log.events = {display::Pan{1, 0}};
      watcher.look();
      painting.look();
      if (painting.title().find(words) != std::string::npos) return true;
    }
    return false;
  }

  std::size_t pictures_kept() {
    const std::lock_guard lock(mutex);
    return kept.size();
  }

  test::Scratch scratch;
  std::string scene = scratch.write("scene.toml", test::small_scene(48, 32));
  watch::Tape tape;
  recording::Writer recording{[this](std::span<const std::uint8_t> bytes) { tape.append(bytes); },
                              device::Device()};
  link::SharedLink link{std::make_unique<link::RecordingLink>(link::open("mem:"), recording, "a view")};
  test::FakeDisplay::Log log;
  watch::Displays displays = [this] {
    watch::Displays all;
    all.push_back(std::make_unique<test::FakeDisplay>(log));
    return all;
  }();
  std::mutex mutex;
  std::vector<std::vector<std::uint8_t>> kept;
  watch::Player player{{}, recording::Trail::grows};
  std::vector<device::Bus> buses = bus::built_in();
  cli::Painting painting{scene, settings, link, 10s, [this](const cli::Painted& painted) {
                           std::vector<std::uint8_t> picture = painted.driver.read_picture();
                           const std::lock_guard lock(mutex);
                           kept.push_back(std::move(picture));
                         }};
  watch::Watcher watcher{
      displays,
      player,
      tape,
      buses,
      {[this] { return painting.title(); }, [this](const device::Bytes& commands) { link.post(commands); }}};
};

} // namespace

TEST_CASE("a scene that changes is painted again while somebody looks and pans") {
  Viewed viewed;
  REQUIRE(viewed.comes_to("done in"));
  CHECK(viewed.pictures_kept() == 1);
  viewed.scratch.write("scene.toml", "no scene");
  CHECK(viewed.comes_to("scene.toml:1:"));
  viewed.scratch.write("scene.toml", test::small_scene(40, 30));
  REQUIRE(viewed.comes_to("done in"));
  REQUIRE(viewed.pictures_kept() == 2);
  CHECK(viewed.kept[0].size() == std::size_t{48} * 32 * 3);
  CHECK(viewed.kept[1].size() == std::size_t{40} * 30 * 3);
  viewed.log.events.clear();
  for (int i = 0; i < 8; ++i) viewed.watcher.look();
  CHECK(viewed.log.words.title.find("done in") != std::string::npos);
  CHECK(viewed.log.screen == device::screen(viewed.player.device()));
}

TEST_CASE("keys that come together while rows are sent add up") {
  Viewed viewed;
  REQUIRE(viewed.comes_to("done in"));
  viewed.log.events.clear();
  viewed.watcher.look();
  const auto before = viewed.player.device().registers.pan_x;
  viewed.scratch.write("scene.toml", test::small_scene(48, 32, "srgb"));
  for (int i = 0; i < 50; ++i) {
    viewed.log.events = {display::Pan{1, 0}, display::Pan{1, 0}};
    viewed.watcher.look();
    viewed.painting.look();
  }
  const auto end = Clock::now() + 1s;
  while (Clock::now() < end) viewed.watcher.look();
  CHECK(viewed.player.device().registers.pan_x == (before + 100) % 512);
}

TEST_CASE("a file that changes twice within a tick of the clock is painted again") {
  Viewed viewed;
  REQUIRE(viewed.comes_to("done in"));
  const auto before = std::filesystem::last_write_time(viewed.scene);
  viewed.scratch.write("scene.toml", test::small_scene(40, 128));
  std::filesystem::last_write_time(viewed.scene, before);
  const auto end = Clock::now() + 10s;
  while (viewed.pictures_kept() < 2 && Clock::now() < end) CHECK(viewed.comes_to(""));
  CHECK(viewed.pictures_kept() == 2);
}

TEST_CASE("a painting ends at once wherever it is") {
  for (const auto after : {0ms, 5ms, 20ms, 100ms}) {
    CAPTURE(after.count());
    const test::Scratch scratch;
    link::SharedLink link(link::open("mem:"));
    std::atomic<bool> is_finished = false;
    auto painting = std::make_unique<cli::Painting>(
        scratch.write("scene.toml", test::small_scene(512, 512)),
        render::Settings{.mode = render::Mode::reference, .samples = 50, .threads = 2}, link, 10s,
        [&](const cli::Painted&) { is_finished = true; });
    std::this_thread::sleep_for(after);
    const auto start = Clock::now();
    painting.reset();
    CHECK(Clock::now() - start < 5s);
    CHECK_FALSE(is_finished);
  }
}

TEST_CASE("what fails while a painting ends is told") {
  const test::Scratch scratch;
  link::SharedLink link(link::open("mem:"));
  std::promise<void> begun;
  cli::Painting painting(scratch.write("scene.toml", test::small_scene(16, 16)), settings, link, 10s,
                         [&](const cli::Painted&) {
                           begun.set_value();
                           std::this_thread::sleep_for(100ms);
                           throw file::WriteError("no room");
                         });
  begun.get_future().wait();
  CHECK_THROWS_AS(painting.finish(), file::WriteError);
}

TEST_CASE("a painting ends though its device says nothing") {
  const test::Scratch scratch;
  std::promise<void> over;
  const test::Peer silent(link::UnixAddress{scratch / "s"},
                          [end = over.get_future().share()](int) { end.wait(); });
  link::SharedLink link(link::open(silent.address()));
  const auto start = Clock::now();
  {
    const cli::Painting painting(scratch.write("scene.toml", test::small_scene()), settings, link, 60s,
                                 [](const cli::Painted&) {});
    std::this_thread::sleep_for(50ms);
  }
  CHECK(Clock::now() - start < 10s);
  over.set_value();
}
