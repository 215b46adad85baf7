#pragma once
// Straight lines through measurements.

#include <optional>
#include <vector>

namespace halftone::bench {

struct Sighting {
  double x = 0;
  double y = 0;
};

struct Fit {
  double at_zero = 0;
  double slope = 0;
  double r_squared = 0; ///< share of the variance of y that the line explains
};

/// By least squares. At least two different x and two different y.
Fit fit(const std::vector<Sighting>& sightings);

/// The exponent b of y ~ x^b, both above 0, by least squares in the logarithms; nothing for fewer than two
/// different x.
std::optional<double> exponent(const std::vector<Sighting>& sightings);

} // namespace halftone::bench
