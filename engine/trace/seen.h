#pragma once
// What each ray of a slice sees: the boundary or opaque surface at its end, after all boundaries that are not
// seen.

#include "meeting.h"

#include <halftone/trace/trace.h>

#include <cstdint>
#include <span>
#include <vector>

namespace halftone::trace {

/// Part of a queue, [begin, end).
struct Slice {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

enum class SeenKind : std::uint8_t {
  nothing,
  opaque,
  entering, ///< a glass solid, from outside
  leaving,  ///< a glass solid, from inside
};

/// One entry a ray of the slice in every array.
struct Seen {
  std::vector<SeenKind> kind;
  std::vector<Met> met;    ///< the surface, or the boundary whose normal and material count
  std::vector<int> before; ///< medium that the ray arrives in
  std::vector<int> behind; ///< of a boundary: the set of solids behind it
};

struct SeenScratch {
  MeetingScratch meeting;
  std::vector<std::size_t> active;              ///< rays of the queue that have not seen anything yet
  std::vector<std::optional<Meeting>> meetings; ///< of the active rays
  std::vector<std::size_t> pending;             ///< rays that are asked together
  std::vector<std::size_t> places;              ///< theirs among the active ones
  std::vector<std::optional<Meeting>> found;    ///< of the pending ones
};

/// Moves the rays of the slice to what they see: origin, surface, weight, set of solids and gap are then
/// those with which each arrives there. eye: of rays of depth 1, else empty.
void find_seen(const Prepared& prepared, InsideSets& sets, Rays& rays, Slice slice,
               std::span<const EyeRay> eye, SeenScratch& scratch, Seen& seen);

} // namespace halftone::trace
