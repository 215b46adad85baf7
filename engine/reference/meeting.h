#pragma once
// What a ray meets next: all surfaces at one distance, sorted as the scene format's section 3 ("Contact")
// says: first all exits, together; then an opaque surface; then all entries, together.

#include "cut.h"

#include <vector>

namespace halftone::reference {

/// A face of a body.
struct Met {
  int body = -1;
  int face = -1;
};

/// What touches a surface from one side, as a ray in the gap on the surface meets it at distance zero.
struct Touching {
  Met opaque;               ///< the opaque surface that is seen there; body < 0: none
  std::vector<Met> entries; ///< glass solids that begin there
};

struct Meeting {
  double t = 0;
  int surface = -1;
  bool outward = false;   ///< the ray goes to the side of the plane's normal, or out of the quadric
  std::vector<Met> exits; ///< glass solids that end there
  Touching ahead;         ///< what comes behind the exits
};

/// The solids that a ray is in, as indices of bodies in ascending order.
using Inside = std::vector<int>;

bool is_in(const Inside& inside, int body);
Inside without(const Inside& inside, const std::vector<Met>& exits);
Inside with(const Inside& inside, const std::vector<Met>& entries);

/// The solids that contain a point.
Inside solids_around(const World& world, const Vec3& point);

/// The glass solid of the set that stands last in the file, or -1 for air.
int medium(const World& world, const Inside& inside);

/// What touches the surface that the line starts on, on the side that it goes to.
Touching touching(const World& world, const Line& line);

std::optional<Meeting> next_meeting(const World& world, const Line& line, const Inside& inside);

} // namespace halftone::reference
