#include <halftone/shade/fresnel.h>
#include <halftone/shade/local.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace halftone::shade;
using halftone::scene::Light;

TEST_CASE(
    "a surface lit from 60 degrees and seen in the mirror direction has half the diffuse term and the whole "
    "highlight") {
  const double s = std::sqrt(3.0) / 2;
  SurfacePoint point;
  point.normal = {0, 0, 1};
  point.direction = {s, 0, -0.5}; // towards +x and down; the light stands on the side that the ray goes to
  point.albedo = {0.2, 0.4, 0.8};
  point.specular = {0.5, 0.25, 0};
  point.shininess = 7;
  // r = 2 (n . l) n - l points back along the ray where l is the ray's own mirror direction.
  const Light light{{s * 5, 0, 0.5 * 5}, {1, 1, 2}};
  REQUIRE(faces(point, light));
  const Color color = direct_light(point, light);
  CHECK(color.r == Approx(0.2 * 0.5 + 0.5));
  CHECK(color.g == Approx(0.4 * 0.5 + 0.25));
  CHECK(color.b == Approx(2 * 0.8 * 0.5));
}

TEST_CASE("the highlight falls with the power of the cosine to the mirror direction") {
  SurfacePoint point;
  point.normal = {0, 0, 1};
  point.direction = {0, 0, -1};
  point.specular = {1, 1, 1};
  point.shininess = 10;
  const double angle = 0.2; // the reflected light leaves the normal by the same angle
  const Light light{{3 * std::sin(angle), 0, 3 * std::cos(angle)}, {1, 1, 1}};
  CHECK(direct_light(point, light).r == Approx(std::pow(std::cos(angle), 10)));
}

TEST_CASE("there is no highlight where the mirrored light goes away from the eye, at any shininess") {
  SurfacePoint point;
  point.normal = {0, 0, 1};
  point.direction = {-0.96, 0, -0.28}; // the eye stands low on the light's side
  point.albedo = {0.8, 0.8, 0.8};
  point.specular = {1, 1, 1};
  const Light light{{3, 0, 3}, {1, 1, 1}}; // mirrored to (-1, 0, 1), which is over 90 degrees from the eye
  for (const double shininess : {0.0, 1.0, 2.0}) {
    point.shininess = shininess;
    CHECK(direct_light(point, light).r == Approx(0.8 * std::sqrt(0.5)));
  }
}

TEST_CASE("a light behind the surface or in its plane is not faced") {
  SurfacePoint point;
  point.normal = {0, 0, 1};
  CHECK_FALSE(faces(point, {{0, 0, -1}, {1, 1, 1}}));
  CHECK_FALSE(faces(point, {{5, 2, 0}, {1, 1, 1}}));
  CHECK(faces(point, {{5, 2, 0x1p-1000}, {1, 1, 1}}));
}

TEST_CASE("rounding makes no highlight brighter than its light and no light negative at any shininess") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> component(-1, 1);
  const auto direction = [&] {
    return glm::normalize(Vec3{component(random), component(random), component(random)});
  };
  SurfacePoint point;
  point.specular = {1, 0, 0};
  point.shininess = 1e60; // a cosine of 1 + 2^-52 once made infinity of it
  for (int i = 0; i < 20'000; ++i) {
    point.normal = direction();
    const Vec3 to_light = direction();
    const Light mirrored{to_light * std::abs(component(random)), {1, 1, 1}};
    point.direction = reflect(-to_light, point.normal) * -1.0;
    if (faces(point, mirrored)) REQUIRE(direct_light(point, mirrored).r <= 1);

    const Vec3 along = glm::cross(point.normal, direction()); // grazing, up to rounding
    const Light grazing{along * 3.0, {1e60, 1e60, 1e60}};
    point.albedo = {0, 1, 1};
    if (faces(point, grazing)) REQUIRE(direct_light(point, grazing).g >= 0);
  }
}
