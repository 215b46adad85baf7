// Work against the number of objects, counted: what is quadratic shows at a thousand, on any machine.

#include "growth.h"

#include <halftone/scene/world.h>
#include <halftone/trace/trace.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <limits>

using namespace halftone;
using namespace halftone::bench;

TEST_CASE("the exponent of a power is found") {
  std::vector<Grown> runs;
  for (const int objects : {100, 1'000, 10'000}) {
    Grown run;
    run.objects = objects;
    run.comparisons = static_cast<std::uint64_t>(objects) * objects;
    runs.push_back(run);
  }
  const auto comparisons = [](const Grown& run) { return static_cast<double>(run.comparisons); };
  CHECK(exponent(runs, comparisons).value() == Approx(2));
  runs.resize(1);
  CHECK_FALSE(exponent(runs, comparisons).has_value());
}

TEST_CASE("a field is the same each time, and other with another seed") {
  const auto places = [](std::uint64_t seed) {
    std::vector<double> all;
    for (const scene::Object& object : make_field({FieldKind::mixed, 50, 8, 8, seed}).objects)
      all.push_back(object.placement.translate.x);
    return all;
  };
  CHECK(places(3) == places(3));
  CHECK(places(3) != places(4));
  CHECK(places(3).size() == 51);
}

TEST_CASE("work and memory grow no faster than the objects") {
  for (const FieldKind kind : {FieldKind::flat, FieldKind::round, FieldKind::mixed}) {
    std::vector<Grown> runs;
    // As many pixels an object as 320 x 240 have for 600 to 10,000.
    for (const int objects : {100, 400, 1'600})
      runs.push_back(grow({.kind = kind, .objects = objects, .width = 128, .height = 96}, 1));
    const auto comparisons =
        exponent(runs, [](const Grown& run) { return static_cast<double>(run.comparisons); });
    const auto bytes =
        exponent(runs, [](const Grown& run) { return static_cast<double>(run.prepared_bytes); });
    INFO(text_of({{kind, runs}}));
    CHECK(comparisons.value() < 1.1);
    CHECK(bytes.value() < 1.1);
    CHECK(bytes.value() > 0.7);
  }
}

// From how many bodies on the hierarchy is faster than a look at every body, one by one and by packets: an
// eye ray through the middle of each pixel with its tree.
TEST_CASE("a look at every body and the hierarchy, in seconds", "[.][search]") {
  for (const FieldKind kind : {FieldKind::flat, FieldKind::round, FieldKind::mixed})
    for (const int objects : {7, 15, 31, 63, 99, 199, 399}) {
      const scene::World world = scene::make_world(make_field({.kind = kind, .objects = objects}));
      std::vector<trace::EyeRay> rays;
      for (int y = 0; y < world.camera.height; ++y)
        for (int x = 0; x < world.camera.width; ++x)
          rays.push_back({world.camera.direction(x + 0.5, y + 0.5), {}});
      std::vector<trace::Sample> samples(rays.size());
      std::cout << name(kind) << ", " << world.bodies.size() << " bodies:";
      const std::pair<trace::Search, core::Simd> ways[] = {{trace::Search::all, core::Simd::baseline},
                                                           {trace::Search::all, core::widest_simd()},
                                                           {trace::Search::hierarchy, core::Simd::baseline},
                                                           {trace::Search::hierarchy, core::widest_simd()}};
      for (const auto& [search, simd] : ways) {
        const trace::Tracer tracer(world, search, simd);
        double least = std::numeric_limits<double>::infinity();
        for (int run = 0; run < 5; ++run) {
          trace::Counts counts;
          const std::clock_t before = std::clock();
          tracer.trace(rays, samples, counts);
          least = std::min(least, static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
        }
        std::cout << ' ' << least;
      }
      std::cout << '\n';
    }
}
