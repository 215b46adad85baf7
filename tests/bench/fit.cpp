#include "fit.h"

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

} // namespace halftone::bench
