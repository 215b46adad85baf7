#include <halftone/core/elementary.h>
#include <halftone/core/exponential.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

namespace core = halftone::core;

// The oracle is the C library in long double, 11 bits more than double.

TEST_CASE("exp is within 2^-51 of the long double exp") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-700, 700);
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 2 ? uniform(random) : uniform(random) / 1024;
    const long double truth = std::exp(static_cast<long double>(x));
    const long double error = std::fabs((core::exp(x) - truth) / truth);
    INFO("x = " << x << ", error in units of 2^-53: " << static_cast<double>(error * 0x1p53L));
    REQUIRE(error < 0x1p-51L);
  }
}

TEST_CASE("exp has its limits") {
  CHECK(core::exp(0) == 1);
  CHECK(core::exp(-0.0) == 1);
  CHECK(core::exp(-1e9) == 0);
  CHECK(std::isinf(core::exp(1e9)));
}

TEST_CASE("exp of three numbers at once has the same bits") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> exponent(-60, 11);
  const std::array limits{0.0, -0.0, 689.9, -690.0, 710.0, -746.0, 1e300, -1e300};
  const auto number = [&] {
    if (random() % 16 == 0) return limits[random() % limits.size()];
    return (random() % 4 ? -1 : 1) * std::exp2(exponent(random));
  };
  for (const core::Simd simd : {core::Simd::baseline, core::Simd::avx2, core::Simd::avx512}) {
    if (simd > core::widest_simd()) continue;
    const core::ExpOfThree exp_of_three = core::exp_of_three(simd);
    for (int i = 0; i < 100'000; ++i) {
      const core::Vec3 x{number(), number(), number()};
      const core::Vec3 power = exp_of_three(x);
      INFO(core::name(simd) << ", " << x.x << ", " << x.y << ", " << x.z);
      REQUIRE(power == core::Vec3{core::exp(x.x), core::exp(x.y), core::exp(x.z)});
    }
  }
}

TEST_CASE("log is within 2^-50 of the long double log") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-600, 600);
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 2 ? std::exp2(uniform(random)) : std::exp2(uniform(random) / 4096);
    const long double truth = std::log(static_cast<long double>(x));
    if (truth == 0) continue;
    const long double error = std::fabs((core::log(x) - truth) / truth);
    INFO("x = " << x << ", error in units of 2^-53: " << static_cast<double>(error * 0x1p53L));
    REQUIRE(error < 0x1p-50L);
  }
}

TEST_CASE("pow keeps the bound that its header states") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> base(0, 1.5), exponent(0, 200);
  for (int i = 0; i < 100'000; ++i) {
    const double b = base(random), e = exponent(random);
    const long double truth = std::pow(static_cast<long double>(b), static_cast<long double>(e));
    if (truth < 0x1p-1000L) continue;
    const long double error = std::fabs((core::pow(b, e) - truth) / truth);
    INFO("base = " << b << ", exponent = " << e);
    REQUIRE(error < (2 + std::fabs(e * std::log(b))) * 0x1p-50L);
  }
  CHECK(core::pow(0, 0) == 1);
  CHECK(core::pow(0, 3) == 0);
  CHECK(core::pow(1, 1e6) == 1);
}

TEST_CASE(
    "sine and cosine are within 2^-52, and relative to their size away from multiples of a right angle") {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-8, 8), wide(-1024, 1024);
  for (int i = 0; i < 100'000; ++i) {
    const double x = i % 3 == 0 ? wide(random) : i % 3 == 1 ? uniform(random) : uniform(random) / 1024;
    const auto [sin, cos] = core::sin_cos(x);
    const long double true_sin = std::sin(static_cast<long double>(x));
    const long double true_cos = std::cos(static_cast<long double>(x));
    INFO("x = " << x << ", sine off by " << static_cast<double>(sin - true_sin) << ", cosine by "
                << static_cast<double>(cos - true_cos));
    REQUIRE(std::fabs(sin - true_sin) < 0x1p-52L);
    REQUIRE(std::fabs(cos - true_cos) < 0x1p-52L);
    if (std::fabs(true_sin) > 0x1p-20L) REQUIRE(std::fabs(sin / true_sin - 1) < 0x1p-50L);
    if (std::fabs(true_cos) > 0x1p-20L) REQUIRE(std::fabs(cos / true_cos - 1) < 0x1p-50L);
  }
  CHECK(core::sin_cos(0).sin == 0);
  CHECK(core::sin_cos(0).cos == 1);
}
