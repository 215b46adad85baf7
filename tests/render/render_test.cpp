#include <halftone/render/render.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace halftone;

namespace {

scene::Scene glass_ball_on_a_floor() {
  scene::Scene built;
  built.image.width = 40;
  built.image.height = 30;
  built.camera = {{0, -6, 3}, {0, 0, 0.5}, {0, 0, 1}, 40};
  built.background = {0.3, 0.4, 0.6};
  built.ambient = core::Color{0.2};
  built.lights.push_back({{-4, -5, 8}, core::Color{0.8}});
  built.materials.resize(3);
  built.materials[1].checker = scene::Checker{{0.1, 0.2, 0.3}, 0.7, 0, 1};
  built.materials[2].glass = scene::Glass{1.5, {0.2, 0.1, 0.1}};
  built.materials[2].diffuse = core::black;
  built.objects.resize(2);
  built.objects[0].shape = scene::Polygon{{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}}};
  built.objects[0].material = 1;
  built.objects[1].shape = scene::Sphere{{0, 0, 1}, 1};
  built.objects[1].material = 2;
  return built;
}

struct Drawn {
  std::vector<core::Color> radiance;
  std::vector<std::uint8_t> rgb;
  render::Statistics statistics;
};

Drawn draw(const scene::Scene& built, const render::Settings& settings) {
  Drawn drawn;
  int expected = 0;
  drawn.statistics = render::render(built, settings, [&](const render::Row& row) {
    REQUIRE(row.y == expected++);
    drawn.radiance.insert(drawn.radiance.end(), row.radiance.begin(), row.radiance.end());
    drawn.rgb.insert(drawn.rgb.end(), row.rgb.begin(), row.rgb.end());
  });
  REQUIRE(expected == built.image.height);
  return drawn;
}

} // namespace

TEST_CASE("rows arrive from top to bottom with the same bits for any number of threads") {
  scene::Scene built = glass_ball_on_a_floor();
  built.image.height = 130; // five bands of rows by area, between which threads are divided
  built.lights.push_back({{-3, 2, 5}, core::Color{0.3}});
  using render::Mode;
  struct Way {
    Mode mode;
    std::optional<int> lines;
  };
  for (const Way& way : {Way{Mode::full, {}}, Way{Mode::reference, {}}, Way{Mode::local, 3},
                         Way{Mode::scanline, 3}, Way{Mode::local, {}}, Way{Mode::scanline, {}}}) {
    const auto settings = [&](int threads) {
      return render::Settings{.mode = way.mode, .samples = 2, .threads = threads, .lines = way.lines};
    };
    const Drawn one = draw(built, settings(1));
    for (const int threads : {2, 3, 8, 100}) {
      const Drawn several = draw(built, settings(threads));
      INFO("mode " << render::name(way.mode) << ", threads " << threads);
      CHECK(several.radiance == one.radiance);
      CHECK(several.rgb == one.rgb);
      CHECK(several.statistics.rays.refracted == one.statistics.rays.refracted);
    }
  }
}

TEST_CASE("full and reference converge to the same picture") {
  const scene::Scene built = glass_ball_on_a_floor();
  const auto rmse = [&](int samples) {
    const Drawn full = draw(built, {render::Mode::full, samples, 2});
    const Drawn reference = draw(built, {render::Mode::reference, samples, 2});
    double sum = 0;
    for (std::size_t i = 0; i < full.rgb.size(); ++i) {
      const double difference = full.rgb[i] - reference.rgb[i];
      sum += difference * difference;
    }
    return std::sqrt(sum / static_cast<double>(full.rgb.size()));
  };
  // The error of a sampled edge falls as n^-1 or faster in samples per side: four times as many leave a
  // quarter.
  const double coarse = rmse(4), fine = rmse(16);
  INFO("rmse at 4: " << coarse << ", at 16: " << fine);
  CHECK(coarse > 1); // they sample at different places
  CHECK(fine < coarse / 3);
}

TEST_CASE("the statistics count what was cast") {
  const scene::Scene built = glass_ball_on_a_floor();
  const Drawn drawn = draw(built, {render::Mode::full, std::nullopt, 1});
  CHECK(drawn.statistics.samples_per_side == 4);
  CHECK(drawn.statistics.rays.eye == 40 * 30 * 16);
  CHECK(drawn.statistics.rays.refracted > 0);
  CHECK(drawn.statistics.rays.shadow > 0);
  CHECK(drawn.statistics.traced_pixels == 40 * 30);
}

TEST_CASE("what the sink throws ends the render and reaches the caller") {
  const scene::Scene built = glass_ball_on_a_floor();
  int rows = 0;
  CHECK_THROWS_WITH(render::render(built, {render::Mode::full, 1, 2},
                                   [&](const render::Row&) {
                                     if (++rows == 5) throw std::runtime_error("the device is gone");
                                   }),
                    "the device is gone");
  CHECK(rows == 5);
}

TEST_CASE("a render that is stopped delivers no further row and ends soon") {
  scene::Scene built = glass_ball_on_a_floor();
  built.image.width = built.image.height = 512;
  using render::Mode;
  struct Way {
    Mode mode;
    std::optional<int> lines;
  };
  for (const Way& way : {Way{Mode::local, {}}, {Mode::local, 8}, {Mode::reference, {}}}) {
    CAPTURE(render::name(way.mode), way.lines.value_or(0));
    std::stop_source stop;
    int rows = 0;
    // In the midst of the rows, by whoever takes them.
    const auto after_three = [&](const render::Row&) {
      if (++rows == 3) stop.request_stop();
    };
    render::render(built, {.mode = way.mode, .samples = 2, .threads = 2, .lines = way.lines}, after_three,
                   stop.get_token());
    CHECK(rows == 3);
  }
  // Before the first row, which would take minutes, by another thread.
  std::stop_source stop;
  int rows = 0;
  const auto start = std::chrono::steady_clock::now();
  const std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  render::render(
      built, {.mode = Mode::reference, .samples = 200, .threads = 2}, [&](const render::Row&) { ++rows; },
      stop.get_token());
  CHECK(rows == 0);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("what a scene does not need is counted and changes no bit") {
  scene::Scene built = glass_ball_on_a_floor();
  scene::Object box;
  box.shape = scene::Box{{-3, 0, 0}, {-2, 1, 1}};
  built.objects.push_back(box);
  const Drawn plain = draw(built, {});
  CHECK(plain.statistics.skipped.lights == 0);
  CHECK(plain.statistics.skipped.branches > 0); // of weight 0.04 * 0.04

  scene::Scene more = built;
  more.lights.push_back({{-2.5, 0.5, 0.5}, core::Color{1}}); // in the box
  more.lights.push_back({{4, -5, 8}, core::black});
  const Drawn drawn = draw(more, {});
  CHECK(drawn.statistics.skipped.lights == 2);
  CHECK(drawn.radiance == plain.radiance);
  CHECK(drawn.statistics.rays.shadow == plain.statistics.rays.shadow);

  more.trace.cutoff = 0;
  CHECK(draw(more, {}).statistics.skipped.branches == 0);

  scene::Scene flat = built;
  flat.objects.erase(flat.objects.begin() + 1); // the glass
  CHECK(draw(flat, {}).statistics.skipped.objects == 0);
  box.shape = scene::Box{{-1, -1, -2}, {1, 1, -1}};
  flat.objects.push_back(box); // beneath the floor
  CHECK(draw(flat, {}).statistics.skipped.objects == 1);
  flat.objects.push_back(more.objects[1]);
  CHECK(draw(flat, {}).statistics.skipped.objects == 0); // a ray may meet it
}
