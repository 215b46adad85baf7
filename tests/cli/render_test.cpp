#include "small_scene.h"
#include "support/process.h"
#include "support/scratch.h"

#include <halftone/png/png.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using halftone::test::contents;
using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
using halftone::test::small_scene;
namespace png = halftone::png;

namespace {

/// Little-endian 32-bit float.
float float_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t bits = 0;
  for (std::size_t i = 4; i-- > 0;) bits = bits << 8 | static_cast<std::uint8_t>(bytes.at(offset + i));
  return std::bit_cast<float>(bits);
}

} // namespace

TEST_CASE("render writes the picture in the current folder under the scene's name where no other is given") {
  const Scratch scratch, elsewhere;
  const std::string scene = scratch.write("some.scene.toml", small_scene());
  const Outcome outcome = run_halftone({"render", scene}, {.folder = elsewhere.path()});
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  CHECK(scratch.names() == std::vector<std::string>{"some.scene.toml"});
  CHECK(elsewhere.names() == std::vector<std::string>{"some.scene.png"});
  const png::Picture picture = png::read(elsewhere / "some.scene.png");
  CHECK(picture.width == 24);
  CHECK(picture.height == 16);
  CHECK(*std::max_element(picture.rgb.begin(), picture.rgb.end()) > 100);
}

TEST_CASE("render writes over an older picture") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  scratch.write("s.png", "no picture");
  REQUIRE(run_halftone({"render", "s.toml"}, {.folder = scratch.path()}).exit_code == 0);
  CHECK(png::read(scratch / "s.png").width == 24);
  CHECK(scratch.names() == std::vector<std::string>{"s.png", "s.toml"});
}

TEST_CASE("the screen is the picture in its middle on black") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene(25, 17));
  REQUIRE(
      run_halftone({"render", "s.toml", "--screen", "screen.png"}, {.folder = scratch.path()}).exit_code ==
      0);
  const png::Picture picture = png::read(scratch / "s.png");
  const png::Picture screen = png::read(scratch / "screen.png");
  REQUIRE(screen.width == 512);
  REQUIRE(screen.height == 512);
  png::Picture expected{512, 512, std::vector<std::uint8_t>(512 * 512 * 3, 0)};
  for (std::size_t y = 0; y < 17;
       ++y) // the top left corner is at ((512 - 25) / 2, (512 - 17) / 2), rounded down
    std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(y * 75), 75,
                expected.rgb.begin() + static_cast<std::ptrdiff_t>(((247 + y) * 512 + 243) * 3));
  CHECK(screen == expected);
}

TEST_CASE("the float map holds the radiance of the picture, bottom row first") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene(24, 16, "linear"));
  REQUIRE(run_halftone({"render", "s.toml", "--float", "s.pfm"}, {.folder = scratch.path()}).exit_code == 0);
  const png::Picture picture = png::read(scratch / "s.png");
  const std::string pfm = contents(scratch / "s.pfm");
  const std::string header = "PF\n24 16\n-1.0\n";
  REQUIRE(pfm.starts_with(header));
  REQUIRE(pfm.size() == header.size() + 24 * 16 * 12);
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t i = 0; i < 72; ++i) {
      const double radiance = float_at(pfm, header.size() + ((15 - y) * 72 + i) * 4);
      INFO("row " << y << ", value " << i << ", radiance " << radiance);
      // float has 24 bits, so that a value may lie on the other side of a half
      REQUIRE(std::fabs(std::clamp(radiance, 0.0, 1.0) * 255 - picture.rgb[y * 72 + i]) <= 0.5001);
    }
}

TEST_CASE("the same scene gives the same bytes again, with one thread and with two") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  for (const std::string mode : {"local", "scanline", "full", "reference"}) {
    const std::string fineness = mode == "local" ? "--quality" : mode == "scanline" ? "--lines" : "--samples";
    const auto render = [&](const std::string& threads, const std::string& name) {
      return run_halftone({"render", "s.toml", "--mode", mode, fineness,
                           fineness == "--quality" ? "0.5" : "3", "--threads", threads, "-o", name + ".png",
                           "--float", name + ".pfm", "--screen", name + ".screen.png"},
                          {.folder = scratch.path()})
          .exit_code;
    };
    INFO("mode " << mode);
    REQUIRE(render("1", "one") == 0);
    REQUIRE(render("1", "again") == 0);
    REQUIRE(render("2", "two") == 0);
    for (const std::string kind : {".png", ".pfm", ".screen.png"}) {
      INFO(kind);
      CHECK(contents(scratch / "one" + kind) == contents(scratch / "again" + kind));
      CHECK(contents(scratch / "one" + kind) == contents(scratch / "two" + kind));
    }
  }
}

TEST_CASE("options --samples, --lines, --mode and --show change the picture") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const auto render = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"render", "s.toml", "-o", "p.png"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_halftone(arguments, {.folder = scratch.path()});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return contents(scratch / "p.png");
  };
  const std::vector<std::string> pictures{render({"--mode", "full", "--samples", "1"}),
                                          render({"--mode", "full", "--samples", "5"}),
                                          render({"--mode", "reference", "--samples", "1"}),
                                          render({"--lines", "1"}),
                                          render({"--lines", "5"}),
                                          render({"--mode", "scanline", "--lines", "5"}),
                                          render({"--quality", "8"}),
                                          render({}),
                                          render({"--show", "signatures"}),
                                          render({"--show", "intervals"}),
                                          render({"--show", "samples"}),
                                          render({"--show", "cost"})};
  for (std::size_t a = 0; a < pictures.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      INFO(a << " and " << b);
      CHECK(pictures[a] != pictures[b]);
    }
}

TEST_CASE("an option that the mode has no use for is refused before anything is read or written") {
  const Scratch scratch;
  const std::vector<std::vector<std::string>> wrong{
      {"--mode", "local", "--samples", "4"}, {"--mode", "scanline", "--samples", "4"},
      {"--mode", "full", "--lines", "4"},    {"--mode", "reference", "--lines", "4"},
      {"--mode", "full", "--quality", "1"},  {"--mode", "reference", "--quality", "1"},
      {"--mode", "full", "--show", "cost"},  {"--mode", "reference", "--show", "samples"}};
  for (const auto& options : wrong) {
    std::vector<std::string> arguments{"render", "missing.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_halftone(arguments, {.folder = scratch.path()});
    INFO(options[1] << " " << options[2]);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.starts_with("halftone: " + options[2] + ": mode " + options[1] + " has no use for it"));
    CHECK(scratch.names().empty());
  }
}

TEST_CASE("a render that succeeds says nothing that was not asked for") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  for (const std::string mode : {"local", "scanline", "full", "reference"}) {
    const Outcome outcome = run_halftone({"render", "s.toml", "--mode", mode}, {.folder = scratch.path()});
    INFO("mode " << mode << ", stderr: " << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK((outcome.out + outcome.err).empty());
  }
}

TEST_CASE("option --stats prints for people, on stdout") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const Outcome outcome = run_halftone({"render", "s.toml", "--mode", "full", "--threads", "1", "--stats"},
                                       {.folder = scratch.path()});
  INFO(outcome.out);
  CHECK(
      outcome.out.starts_with("24 x 16 pixels, mode full with 4 x 4 samples a pixel, 1 thread, baseline\n"));
  CHECK(outcome.out.find("eye 6144,") != std::string::npos); // 24 * 16 * 4 * 4
  CHECK(outcome.err.empty());
}

TEST_CASE("an instruction set is taken as it was asked for, and the picture is the same") {
  const Scratch scratch;
  scratch.write("s.toml", small_scene());
  const auto render = [&](const std::string& simd) {
    return run_halftone({"render", "s.toml", "--simd", simd, "--json", "-o", simd + ".png"},
                        {.folder = scratch.path()});
  };
  const Outcome widest = render("auto"), narrow = render("baseline");
  INFO(widest.err << narrow.err);
  REQUIRE(widest.exit_code == 0);
  REQUIRE(narrow.exit_code == 0);
  CHECK(narrow.out.find("\"simd\": \"baseline\"") != std::string::npos);
  CHECK(contents(scratch / "auto.png") == contents(scratch / "baseline.png"));
  for (const std::string simd : {"avx2", "avx512"}) {
    const Outcome asked = render(simd);
    if (asked.exit_code == 2) { // this processor does not have it
      CHECK(asked.err.find("--simd: this processor does not have " + simd) != std::string::npos);
      continue;
    }
    REQUIRE(asked.exit_code == 0);
    CHECK(asked.out.find("\"simd\": \"" + simd + "\"") != std::string::npos);
    CHECK(contents(scratch / "auto.png") == contents(scratch / simd + ".png"));
  }
}
