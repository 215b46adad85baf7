#include "against_reference.h"
#include "support/random_scene.h"
#include "tally.h"

#include <catch2/catch.hpp>

#include <string>

// Random scenes with every feature mixed: default rows against the brute-force renderer.

using namespace halftone;

namespace {

void draw(std::uint64_t seed, test::Tally& tally) {
  test::RandomScene random(seed);
  scene::Scene scene = random.make({9, true, true, seed % 3 == 0, seed % 4 == 0});
  scene.image.width = 32;
  scene.image.height = 24;
  test::add_picture(scene, "seed " + std::to_string(seed), tally);
}

test::Tally mixed(std::uint64_t scenes) { return test::tally_of("mixed scenes", scenes, draw); }

} // namespace

TEST_CASE("random scenes of every feature are what the reference shows") { CHECK(mixed(40).failures == 0); }

TEST_CASE("random scenes of every feature are what the reference shows: many", "[.][long]") {
  CHECK(mixed(5'000).failures == 0);
}
