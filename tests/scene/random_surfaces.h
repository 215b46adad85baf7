#pragma once
// Random numbers and directions for surfaces.

#include <halftone/core/vector.h>

#include <random>

struct Random {
  std::mt19937_64 engine;

  double number(double least, double most) { return std::uniform_real_distribution(least, most)(engine); }
  halftone::core::Vec3 direction() {
    halftone::core::Vec3 d;
    do d = {number(-1, 1), number(-1, 1), number(-1, 1)};
    while (glm::length(d) > 1 || glm::length(d) < 0.1);
    return glm::normalize(d);
  }
};
