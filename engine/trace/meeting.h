#pragma once
// What a ray meets next: all surfaces at one distance, sorted as the scene format's section 3 ("Contact")
// says: first all exits, together; then an opaque surface; then all entries, together.

#include "inside_sets.h"
#include "prepared.h"
#include "rays.h"

#include <optional>
#include <span>
#include <vector>

namespace halftone::trace {

/// In the order in which surfaces at one distance are met. A wall is the far side of an opaque solid that the
/// eye is in.
enum class EventKind { exit, wall, opaque, entry };

struct Event {
  EventKind kind{};
  Met met;
  int surface = -1;
};

/// Memory that calls in a row share.
struct MeetingScratch {
  std::vector<geometry::Near> near;
  std::vector<Event> events; ///< at the nearest distance so far
  geometry::Packet packet;
  geometry::Meetings met;        ///< by the packet
  std::uint64_t comparisons = 0; ///< of a ray with a body, so far
};

struct Meeting {
  double t = 0;
  int surface = -1;
  bool outward = false; ///< the ray goes to the side of the plane's normal, or out of the quadric
  Gap gap;              ///< what comes behind the exits; the exits themselves are what lies behind the ray
};

/// The next meeting of a ray that is in the given solids, with any body. The gap's entries are added to
/// `mets`.
std::optional<Meeting> next_meeting(const Prepared& prepared, const geometry::Line& line,
                                    std::span<const int> inside, MeetingScratch& scratch, Mets& mets);

/// The same if the ray can meet only the candidates, which include the solids that it is in. Ascending.
std::optional<Meeting> next_meeting(const Prepared& prepared, const geometry::Line& line,
                                    std::span<const int> inside, std::span<const int> candidates,
                                    MeetingScratch& scratch, Mets& mets);

/// The next meetings of some of the rays, all of which can meet only the candidates; any body, where there
/// are none. meetings.size() == some.size().
void next_meetings(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
                   std::span<const std::size_t> some, std::span<const int> candidates,
                   MeetingScratch& scratch, Mets& mets, std::span<std::optional<Meeting>> meetings);

/// What touches the surface that the line starts on, on the side that it goes to.
Touching touching(const Prepared& prepared, const geometry::Line& line, MeetingScratch& scratch, Mets& mets);

} // namespace halftone::trace
