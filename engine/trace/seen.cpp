// The walk of a ray through boundaries that are not seen (the scene format, section 3, "Which medium"), for
// all rays of a slice at once: find all next meetings, sort out who is done, and go round again with the
// rest.
//
// Invariant: a ray ends. A straight line enters and leaves each convex body once, so it has at most two
// meetings a body; a ray that rounding would keep going in a corner for longer sees nothing.

#include "seen.h"

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
    if (before >= 0) ray.weight = ray.weight * prepared_.transmittance(before, meeting.t);
    ray.origin = ray.origin + ray.direction * meeting.t;
    ray.at_eye = ray.at_eye && ray.origin == prepared_.world.camera.eye;
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

/// The first meetings of rays of depth 1, those with the same candidates together.
void meet_candidates(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
                     std::span<const std::size_t> some, std::span<const EyeRay> eye, MeetingScratch& scratch,
                     Mets& mets, std::span<std::optional<Meeting>> meetings) {
  const auto candidates_of = [&](std::size_t k) { return eye[rays[some[k]].sample].candidates; };
  for (std::size_t first = 0, end = 0; first < some.size(); first = end) {
    const auto candidates = candidates_of(first);
    const auto has_these = [&](std::size_t k) {
      return candidates_of(k).data() == candidates.data() && candidates_of(k).size() == candidates.size();
    };
    for (end = first + 1; end < some.size() && has_these(end);) ++end;
    next_meetings(prepared, sets, rays, some.subspan(first, end - first), candidates, scratch, mets,
                  meetings.subspan(first, end - first));
    // On the outline of a candidate a ray may miss it by rounding, and see what no list names.
    for (std::size_t k = first; k < end && !candidates.empty(); ++k)
      if (const Ray& ray = rays[some[k]]; !meetings[k])
        meetings[k] = next_meeting(prepared, ray.line(), sets.bodies(ray.inside), scratch, mets);
  }
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
    // A ray that started in a gap is past what was listed.
    if (round == 0 && !eye.empty() && prepared.eye_surface < 0)
      meet_candidates(prepared, sets, rays, active, eye, scratch.meeting, mets, scratch.meetings);
    else
      next_meetings(prepared, sets, rays, active, {}, scratch.meeting, mets, scratch.meetings);
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
