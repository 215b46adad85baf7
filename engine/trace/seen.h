#pragma once
// What each ray of a slice sees: the boundary or opaque surface at its end, after all boundaries that are not
// seen.

#include "meeting.h"

#include <halftone/trace/trace.h>

#include <cstdint>
#include <span>
#include <vector>

namespace halftone::trace {

enum class SeenKind : std::uint8_t {
  nothing,
  opaque,
  entering, ///< a glass solid, from outside
  leaving,  ///< a glass solid, from inside
};

struct Seen {
  SeenKind kind = SeenKind::nothing;
  Met met;         ///< the surface, or the boundary whose normal and material count
  int before = -1; ///< medium that the ray arrives in
  int behind = 0;  ///< of a boundary: the set of solids behind it
};

struct SeenScratch {
  MeetingScratch meeting;
  std::vector<std::size_t> active;              ///< rays that have not seen anything yet
  std::vector<std::optional<Meeting>> meetings; ///< theirs
};

/// Moves the rays to what they see: origin, surface, weight, set of solids and gap are then those with which
/// each arrives there. eye: of rays of depth 1, else empty. The gaps' entries are added to `mets`.
/// seen.size() == rays.size().
void find_seen(const Prepared& prepared, InsideSets& sets, std::span<Ray> rays, std::span<const EyeRay> eye,
               SeenScratch& scratch, Mets& mets, std::span<Seen> seen);

} // namespace halftone::trace
