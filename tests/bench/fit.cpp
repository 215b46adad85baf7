#include "fit.h"

#include <algorithm>
#include <cmath>

namespace halftone::bench {

Fit fit(const std::vector<Sighting>& sightings) {
  const double n = static_cast<double>(sightings.size());
  double x = 0, y = 0;
  for (const Sighting& each : sightings) {
    x += each.x / n;
    y += each.y / n;
  }
  double xx = 0, xy = 0, yy = 0; // about the mean, where nothing cancels
  for (const Sighting& each : sightings) {
    xx += (each.x - x) * (each.x - x);
    xy += (each.x - x) * (each.y - y);
    yy += (each.y - y) * (each.y - y);
  }
  return {y - xy / xx * x, xy / xx, xy * xy / (xx * yy)};
}

std::optional<double> exponent(const std::vector<Sighting>& sightings) {
  std::vector<Sighting> logarithms;
  for (const Sighting& each : sightings) logarithms.push_back({std::log(each.x), std::log(each.y)});
  if (std::all_of(logarithms.begin(), logarithms.end(),
                  [&](const Sighting& each) { return each.x == logarithms[0].x; }))
    return std::nullopt;
  return fit(logarithms).slope;
}

} // namespace halftone::bench
