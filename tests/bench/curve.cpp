#include "curve.h"

#include "fit.h"

#include <algorithm>
#include <cmath>

namespace halftone::bench {

std::vector<Point> front(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  std::vector<Point> best;
  for (const Point& point : points)
    if (best.empty() || point.error < best.back().error) best.push_back(point);
  return best;
}

std::optional<double> seconds_at(const std::vector<Point>& points, double error) {
  const std::vector<Point> best = front(points);
  const auto good =
      std::find_if(best.begin(), best.end(), [&](const Point& point) { return point.error <= error; });
  if (good == best.end()) return std::nullopt;
  if (good == best.begin() || good->error <= 0) return good->seconds;
  const Point& before = *(good - 1);
  const double share = std::log(before.error / error) / std::log(before.error / good->error);
  return before.seconds * std::pow(good->seconds / before.seconds, share);
}

std::optional<double> slope(const std::vector<Point>& points) {
  std::vector<Sighting> sightings;
  for (const Point& point : front(points))
    if (point.error > 0) sightings.push_back({point.seconds, point.error});
  return exponent(sightings);
}

} // namespace halftone::bench
