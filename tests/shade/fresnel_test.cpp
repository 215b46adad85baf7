#include "support/skip.h"

#include <halftone/shade/fresnel.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using namespace halftone::shade;

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> result;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) result.push_back(field);
  return result;
}

/// The same reflectance by complex amplitudes, as physics has it, with no case for total reflection.
double reflectance_by_amplitudes(double cos_incidence, double n1, double n2) {
  using Complex = std::complex<double>;
  const Complex sin_behind = n1 / n2 * std::sqrt(1 - cos_incidence * cos_incidence);
  const Complex cos_behind = std::sqrt(Complex{1} - sin_behind * sin_behind);
  const Complex s = (n1 * cos_incidence - n2 * cos_behind) / (n1 * cos_incidence + n2 * cos_behind);
  const Complex p = (n2 * cos_incidence - n1 * cos_behind) / (n2 * cos_incidence + n1 * cos_behind);
  return (std::norm(s) + std::norm(p)) / 2;
}

} // namespace

TEST_CASE("the reflectance agrees with complex amplitudes, total reflection included") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> cosine(0, 1), index(0.3, 3);
  for (int i = 0; i < 20'000; ++i) {
    const double c = cosine(random), n1 = index(random), n2 = index(random);
    INFO("case " << i << ": cos " << c << ", n1 " << n1 << ", n2 " << n2);
    REQUIRE(std::abs(fresnel_reflectance(c, n1, n2) - reflectance_by_amplitudes(c, n1, n2)) < 1e-7);
  }
  CHECK(fresnel_reflectance(1, 1, 1.5) == Approx(0.04).epsilon(1e-15));
  CHECK(fresnel_reflectance(0, 1, 1.5) == 1);
  CHECK(fresnel_reflectance(0.4, 1.3, 1.3) < 1e-30);
}

TEST_CASE("the reflectance agrees with published figures") {
  std::ifstream file(HALFTONE_SHARED_DIR "/numbers/fresnel.csv");
  if (!file) {
    halftone::test::skip_anywhere("the published reflectances are not there");
    return;
  }
  int compared = 0;
  std::string line;
  std::getline(file, line); // n1,n2,angle_deg,Rs,Rp,R_unpol,theta_t_deg,tol_abs,source
  while (std::getline(file, line)) {
    const auto field = fields(line);
    INFO(line);
    REQUIRE(field.size() >= 8);
    const double n1 = std::stod(field[0]), n2 = std::stod(field[1]);
    const double cosine = std::cos(radians(std::stod(field[2])));
    const double tolerance = std::stod(field[7]);
    if (!field[5].empty()) {
      CHECK(std::abs(fresnel_reflectance(std::abs(cosine), n1, n2) - std::stod(field[5])) <= tolerance);
      ++compared;
    } else if (!field[3].empty() && !field[4].empty()) {
      const double mean = (std::stod(field[3]) + std::stod(field[4])) / 2;
      CHECK(std::abs(fresnel_reflectance(cosine, n1, n2) - mean) <= tolerance);
      ++compared;
    }
  }
  CHECK(compared > 0);
}

TEST_CASE("refraction keeps n sin(angle), the plane of incidence and unit length") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(0, 90), index(0.5, 2.5), component(-1, 1);
  int refracted = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 normal = glm::normalize(Vec3{component(random), component(random), component(random)});
    const Vec3 across = glm::normalize(glm::cross(normal, Vec3{0.3, -0.5, 0.8}));
    const double theta = radians(angle(random)), n1 = index(random), n2 = index(random);
    const Vec3 direction = across * std::sin(theta) - normal * std::cos(theta);
    const auto behind = refract(direction, normal, n1, n2);
    INFO("case " << i << ": angle " << theta << ", n1 " << n1 << ", n2 " << n2);
    REQUIRE(behind.has_value() == (n1 * std::sin(theta) < n2));
    if (!behind) continue;
    ++refracted;
    REQUIRE(std::abs(glm::length(*behind) - 1) < 1e-14);
    REQUIRE(glm::dot(*behind, normal) <= 0);
    REQUIRE(std::abs(n2 * glm::dot(*behind, across) - n1 * std::sin(theta)) < 1e-13);
    REQUIRE(std::abs(glm::dot(*behind, glm::cross(across, normal))) < 1e-14);
  }
  CHECK(refracted > 5'000);
}

TEST_CASE("refraction along the normal goes straight on between any media") {
  const std::vector<double> indices{1e-60, 1e-8, 1, 1.5, 1e8, 1e16, 1e60};
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> component(-1, 1);
  for (int i = 0; i < 1'000; ++i) {
    const Vec3 normal = i == 0
                            ? Vec3{0, 0, 1}
                            : glm::normalize(Vec3{component(random), component(random), component(random)});
    for (const double n1 : indices)
      for (const double n2 : indices) {
        INFO("case " << i << ": n1 " << n1 << ", n2 " << n2);
        const auto behind = refract(-normal, normal, n1, n2);
        if (i == 0) REQUIRE(behind.has_value());
        if (behind) REQUIRE(std::abs(glm::length(*behind) - 1) < 1e-14); // once not a number
        if (behind) REQUIRE(glm::dot(*behind, normal) <= 0);
        if (n1 < 1e3 * n2) REQUIRE(glm::distance(behind.value(), -normal) < 1e-12);
      }
  }
}

TEST_CASE("light is absorbed per channel by Beer and Lambert's law") {
  const Color left = transmittance({0, 0.5, 2}, 3);
  CHECK(left.r == 1);
  CHECK(left.g == Approx(std::exp(-1.5)).epsilon(1e-15));
  CHECK(left.b == Approx(std::exp(-6.0)).epsilon(1e-15));
  CHECK(transmittance(Color{0}, 1e300) == Color{1});
}
