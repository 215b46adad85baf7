// render with a device as a process that is bad in many ways, or mute.

#include "link/peer.h"
#include "serve/server_process.h"
#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

using namespace halftone;
using test::contents;
using test::Outcome;
using test::run_halftone;
using test::Scratch;

namespace {

Outcome render(const Scratch& scratch, const std::string& device) {
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome = run_halftone({"render", "s.toml", "-o", "p.png", "--device", device, "--timeout", "0.2"},
                                 {.folder = scratch.path()});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
  return outcome;
}

} // namespace

TEST_CASE("over a bad link render gives the picture, or says which rows are missing and leaves none") {
  const Scratch scratch, sockets;
  scratch.write("s.toml", test::small_scene(96, 64));
  REQUIRE(render(scratch, "mem:").exit_code == 0);
  const std::string picture = contents(scratch / "p.png");
  int whole = 0, broken = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::filesystem::remove(scratch / "p.png");
    const test::ServerProcess server(
        {"--listen", "unix:" + sockets / std::to_string(seed), "--fault", std::to_string(seed)});
    const Outcome outcome = render(scratch, server.address());
    INFO("seed " << seed << ", exit code " << outcome.exit_code << ": " << outcome.err);
    CHECK(outcome.out.empty());
    if (outcome.exit_code == 0) {
      ++whole;
      CHECK((contents(scratch / "p.png") == picture));
      CHECK(outcome.err.empty());
      continue;
    }
    ++broken;
    CHECK((outcome.exit_code == 5 || outcome.exit_code == 6));
    CHECK(outcome.err.find(" row") != std::string::npos);
    CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
  }
  CHECK(whole >= 5);
  CHECK(broken >= 1);
}

TEST_CASE("a device that takes everything and never answers is exit code 6, and no picture") {
  const Scratch scratch, sockets;
  scratch.write("s.toml", test::small_scene());
  const test::Peer mute(link::UnixAddress{sockets / "s"},
                        [](int connection) { test::read_from(connection, ~std::size_t{0}); });
  const Outcome outcome = render(scratch, mute.address());
  INFO(outcome.err);
  CHECK(outcome.exit_code == 6);
  CHECK(outcome.err.find("no row of the picture was sent") != std::string::npos);
  CHECK(scratch.names() == std::vector<std::string>{"s.toml"});
}
