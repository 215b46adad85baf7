#include "support/process.h"
#include "support/scratch.h"

#include <halftone/png/png.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using halftone::test::Outcome;
using halftone::test::run_halftone;
using halftone::test::Scratch;
namespace png = halftone::png;

namespace {

/// Two pictures of 10 x 8 that differ by 12 levels in the green of pixel (3, 5), and a smaller one.
struct Pictures {
  Scratch scratch;

  Pictures() {
    png::Picture picture{10, 8, std::vector<std::uint8_t>(240, 100)};
    png::write(scratch / "a.png", picture, png::Encoding::srgb);
    picture.rgb[(5 * 10 + 3) * 3 + 1] = 112;
    png::write(scratch / "b.png", picture, png::Encoding::srgb);
    png::write(scratch / "small.png", {2, 1, std::vector<std::uint8_t>(6)}, png::Encoding::srgb);
  }

  Outcome compare(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "compare");
    return run_halftone(arguments, {.folder = scratch.path()});
  }
};

} // namespace

TEST_CASE("compare tells error, largest difference and its place") {
  const Pictures pictures;
  const Outcome outcome = pictures.compare({"a.png", "b.png"});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("rmse                0.774597\n") != std::string::npos); // 12 / sqrt(240)
  CHECK(outcome.out.find("largest difference  12 at (3, 5)\n") != std::string::npos);
  CHECK(outcome.out.find("over 4 levels       1.25 % of pixels\n") != std::string::npos);
}

TEST_CASE("compare without limits and of equal pictures exits with 0") {
  const Pictures pictures;
  CHECK(pictures.compare({"a.png", "small.png", "--json"}).exit_code != 0);
  CHECK(pictures.compare({"a.png", "a.png", "--max-rmse", "0", "--max-diff", "0"}).exit_code == 0);
}

TEST_CASE("limits of compare are inclusive and exit with 1 where they are passed") {
  const Pictures pictures;
  CHECK(pictures.compare({"a.png", "b.png", "--max-diff", "12"}).exit_code == 0);
  CHECK(pictures.compare({"a.png", "b.png", "--max-diff", "11.9"}).exit_code == 1);
  CHECK(pictures.compare({"a.png", "b.png", "--max-rmse", "0.775"}).exit_code == 0);
  CHECK(pictures.compare({"a.png", "b.png", "--max-rmse", "0.774"}).exit_code == 1);
  const Outcome outcome =
      pictures.compare({"a.png", "b.png", "--max-rmse", "0.5", "--max-diff", "99", "--json"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.err == "halftone: rmse 0.774597 is over 0.5\n");
  CHECK(nlohmann::json::parse(outcome.out).at("largest") == 12);
}

TEST_CASE("pictures of different sizes, and files that are no pictures, exit with 3") {
  const Pictures pictures;
  pictures.scratch.write("text.png", "text");
  for (const std::string other : {"small.png", "text.png", "missing.png", "."}) {
    const Outcome outcome = pictures.compare({"a.png", other, "--diff", "d.png"});
    INFO(other << ": " << outcome.err);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.err.starts_with("halftone: " + other + ": "));
    CHECK(outcome.out.empty());
  }
  CHECK(pictures.scratch.names() == std::vector<std::string>{"a.png", "b.png", "small.png", "text.png"});
}

TEST_CASE("option --diff writes the differences around mid-grey, also where a limit is passed") {
  const Pictures pictures;
  CHECK(pictures.compare({"a.png", "b.png", "--max-diff", "0", "--diff", "d.png"}).exit_code == 1);
  const png::Picture difference = png::read(pictures.scratch / "d.png");
  CHECK(difference.width == 10);
  CHECK(difference.height == 8);
  CHECK(difference.rgb[0] == 128);
  CHECK(difference.rgb[(5 * 10 + 3) * 3 + 1] != 128);
  CHECK(pictures.compare({"a.png", "b.png", "--diff", "missing/d.png"}).exit_code == 4);
  CHECK(pictures.compare({"a.png", "b.png", "--diff", "./b.png"}).exit_code == 2);
}
