// The walk of a ray through boundaries that are not seen (the scene format, section 3, "Which medium"), for
// all rays of a slice at once: find all next meetings, sort out who is done, and go round again with the
// rest.
//
// Invariant: a ray ends. A straight line enters and leaves each convex body once, so it has at most two
// meetings a body; a ray that rounding would keep going in a corner for longer sees nothing.

#include "seen.h"

#include <halftone/shade/fresnel.h>

namespace halftone::trace {

namespace {

class Walk {
public:
  Walk(const Prepared& prepared, InsideSets& sets, const Mets& mets)
      : prepared_(prepared),
        sets_(sets),
        mets_(mets) {}

  /// The ray moves to a meeting and takes its first step there, out of the solids that end. True where it
  /// sees that.
  bool leave_at(const Meeting& meeting, Ray& ray, Seen& seen) const {
    const int before = sets_.medium(ray.inside);
    if (before >= 0)
      ray.weight = ray.weight * shade::transmittance(prepared_.media[before].absorption, meeting.t);
    ray.origin = ray.origin + ray.direction * meeting.t;
    ray.surface = meeting.surface;
    ray.outward = meeting.outward;
    ray.in_gap = true;
    ray.gap = meeting.gap;
    const int outside = with(ray.inside, meeting.gap.behind);
    const int after = sets_.medium(outside);
    if (after == before) {
      ray.inside = outside;
      return false;
    }
    seen = {SeenKind::leaving, of_body(meeting.gap.behind, before), before, outside};
    return true;
  }

  /// The second and third step, in the gap: an opaque surface ends the ray, otherwise it enters what begins
  /// there. True where it sees that.
  bool enter(Ray& ray, Seen& seen) const {
    const Touching& ahead = ray.gap.ahead;
    const int before = sets_.medium(ray.inside);
    if (ahead.opaque.body >= 0) {
      seen = {SeenKind::opaque, ahead.opaque, before, ray.inside};
      return true;
    }
    const int inside = with(ray.inside, ahead);
    const int after = sets_.medium(inside);
    if (after == before) {
      ray.inside = inside;
      ray.in_gap = false;
      return false;
    }
    seen = {SeenKind::entering, of_body(ahead, after), before, inside};
    return true;
  }

private:
  /// The set after crossing all surfaces of one kind; each changes the set by its solid.
  int with(int set, const Touching& together) const {
    for (const Met& met : entries(mets_, together)) set = sets_.toggled(set, met.body);
    return set;
  }

  Met of_body(const Touching& together, int body) const {
    for (const Met& met : entries(mets_, together))
      if (met.body == body) return met;
    return {};
  }

  const Prepared& prepared_;
  InsideSets& sets_;
  const Mets& mets_;
};

/// Of a ray of depth 1, which may have left the eye.
std::optional<Meeting> meeting_from_eye(const Prepared& prepared, const InsideSets& sets, const Ray& ray,
                                        std::span<const int> candidates, MeetingScratch& scratch,
                                        Mets& mets) {
  geometry::Line line = ray.line();
  line.at_eye = line.origin == prepared.world.camera.eye;
  const auto inside = sets.bodies(ray.inside);
  if (!candidates.empty())
    if (const auto meeting = next_meeting(prepared, line, inside, candidates, scratch, mets)) return meeting;
  // On the outline of a candidate a ray may miss it by rounding, and see what no list names.
  return next_meeting(prepared, line, inside, scratch, mets);
}

} // namespace

void find_seen(const Prepared& prepared, InsideSets& sets, std::span<Ray> rays, std::span<const EyeRay> eye,
               SeenScratch& scratch, Mets& mets, std::span<Seen> seen) {
  const Walk walk(prepared, sets, mets);
  std::vector<std::size_t>& active = scratch.active;
  // Rays in no solid first, and the others last: packets of rays that are asked the same.
  active.resize(rays.size());
  std::size_t first = 0, last = rays.size();
  for (std::size_t k = 0; k < rays.size(); ++k) {
    seen[k].kind = SeenKind::nothing;
    if (rays[k].in_gap && walk.enter(rays[k], seen[k])) continue;
    active[sets.bodies(rays[k].inside).empty() ? first++ : --last] = k;
  }
  active.erase(active.begin() + first, active.begin() + last);
  const std::size_t most_rounds = 2 * prepared.world.bodies.size() + 2;
  for (std::size_t round = 0; round < most_rounds && !active.empty(); ++round) {
    scratch.meetings.resize(active.size());
    if (eye.empty()) {
      next_meetings(prepared, sets, rays, active, scratch.meeting, mets, scratch.meetings);
    } else {
      const bool is_first = round == 0 && prepared.eye_surface < 0; // nothing was met in a gap before
      for (std::size_t a = 0; a < active.size(); ++a) {
        const Ray& ray = rays[active[a]];
        const auto candidates = is_first ? eye[ray.sample].candidates : std::span<const int>{};
        scratch.meetings[a] = meeting_from_eye(prepared, sets, ray, candidates, scratch.meeting, mets);
      }
    }
    std::size_t left = 0;
    for (std::size_t a = 0; a < active.size(); ++a) {
      const std::size_t k = active[a];
      const auto& meeting = scratch.meetings[a];
      if (!meeting || walk.leave_at(*meeting, rays[k], seen[k]) || walk.enter(rays[k], seen[k])) continue;
      active[left++] = k;
    }
    active.resize(left);
  }
}

} // namespace halftone::trace
