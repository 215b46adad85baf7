#pragma once
// A contender's settings as a curve of error over time.

#include <optional>
#include <vector>

namespace halftone::bench {

struct Point {
  double seconds = 0;
  double error = 0; ///< RMSE in 8-bit levels
};

/// The settings that no other beats in both, by time: errors fall.
std::vector<Point> front(std::vector<Point> points);

/// Seconds to an error, by straight lines in the logarithms between neighbours of the front. The fastest
/// setting's where that is good enough, nothing where no setting is.
std::optional<double> seconds_at(const std::vector<Point>& points, double error);

/// The exponent b of error ~ seconds^b that fits the front best, by least squares in the logarithms; nothing
/// where it has fewer than two points. Errors of 0 are left out.
std::optional<double> slope(const std::vector<Point>& points);

} // namespace halftone::bench
