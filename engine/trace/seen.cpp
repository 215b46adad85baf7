// The walk of a ray through boundaries that are not seen (the scene format, section 3, "Which medium"), for
// all rays of a slice at once: find all next meetings, sort out who is done, and go round again with the
// rest.
//
// Invariant: a ray ends. A straight line enters and leaves each convex body once, so it has at most two
// meetings a body; a ray that rounding would keep going in a corner for longer sees nothing.

#include "seen.h"

#include <halftone/shade/fresnel.h>

#include <numeric>

namespace halftone::trace {

namespace {

class Walk {
public:
  Walk(const Prepared& prepared, InsideSets& sets, Rays& rays, std::size_t first, Seen& seen)
      : prepared_(prepared),
        sets_(sets),
        rays_(rays),
        first_(first),
        seen_(seen) {}

  /// The ray moves to a meeting and takes its first step there, out of the solids that end. True where it
  /// sees that.
  bool leave_at(std::size_t ray, const Meeting& meeting) const {
    const int before = sets_.medium(rays_.inside[ray]);
    if (before >= 0)
      rays_.set_weight(ray, rays_.weight(ray) *
                                shade::transmittance(prepared_.media[before].absorption, meeting.t));
    rays_.set_origin(ray, rays_.origin(ray) + rays_.direction(ray) * meeting.t);
    rays_.surface[ray] = meeting.surface;
    rays_.outward[ray] = meeting.outward;
    rays_.in_gap[ray] = 1;
    rays_.gap[ray] = meeting.gap;
    const int outside = with(rays_.inside[ray], meeting.gap.behind);
    const int after = sets_.medium(outside);
    if (after == before) {
      rays_.inside[ray] = outside;
      return false;
    }
    see(ray, SeenKind::leaving, of_body(meeting.gap.behind, before), before, outside);
    return true;
  }

  /// The second and third step, in the gap: an opaque surface ends the ray, otherwise it enters what begins
  /// there. True where it sees that.
  bool enter(std::size_t ray) const {
    const Touching& ahead = rays_.gap[ray].ahead;
    const int before = sets_.medium(rays_.inside[ray]);
    if (ahead.opaque.body >= 0) {
      see(ray, SeenKind::opaque, ahead.opaque, before, rays_.inside[ray]);
      return true;
    }
    const int inside = with(rays_.inside[ray], ahead);
    const int after = sets_.medium(inside);
    if (after == before) {
      rays_.inside[ray] = inside;
      rays_.in_gap[ray] = 0;
      return false;
    }
    see(ray, SeenKind::entering, of_body(ahead, after), before, inside);
    return true;
  }

  void see(std::size_t ray, SeenKind kind, const Met& met, int before, int behind) const {
    const std::size_t k = ray - first_;
    seen_.kind[k] = kind;
    seen_.met[k] = met;
    seen_.before[k] = before;
    seen_.behind[k] = behind;
  }

private:
  /// The set after crossing all surfaces of one kind; each changes the set by its solid.
  int with(int set, const Touching& together) const {
    for (const Met& met : rays_.entries(together)) set = sets_.toggled(set, met.body);
    return set;
  }

  Met of_body(const Touching& together, int body) const {
    for (const Met& met : rays_.entries(together))
      if (met.body == body) return met;
    return {};
  }

  const Prepared& prepared_;
  InsideSets& sets_;
  Rays& rays_;
  std::size_t first_;
  Seen& seen_;
};

} // namespace

void find_seen(const Prepared& prepared, InsideSets& sets, Rays& rays, Slice slice,
               std::span<const EyeRay> eye, SeenScratch& scratch, Seen& seen) {
  seen.kind.assign(slice.size(), SeenKind::nothing);
  seen.met.resize(slice.size());
  seen.before.resize(slice.size());
  seen.behind.resize(slice.size());
  const Walk walk(prepared, sets, rays, slice.begin, seen);

  std::vector<std::size_t>& active = scratch.active;
  active.resize(slice.size());
  std::iota(active.begin(), active.end(), slice.begin);
  const std::size_t most_rounds = 2 * prepared.world.bodies.size() + 2;
  for (std::size_t round = 0; round < most_rounds && !active.empty(); ++round) {
    scratch.meetings.assign(active.size(), std::nullopt);
    scratch.pending.clear();
    scratch.places.clear();
    for (std::size_t k = 0; k < active.size(); ++k) {
      const std::size_t ray = active[k];
      if (rays.in_gap[ray]) continue;
      geometry::Line line = rays.line(ray);
      line.at_eye = !eye.empty() && line.origin == prepared.world.camera.eye;
      if (!line.at_eye) {
        scratch.pending.push_back(ray);
        scratch.places.push_back(k);
        continue;
      }
      const auto inside = sets.bodies(rays.inside[ray]);
      if (round == 0)
        scratch.meetings[k] = next_meeting(prepared, line, inside, eye[rays.sample[ray]].candidates,
                                           scratch.meeting, rays.mets);
      // On the outline of a candidate a ray may miss it by rounding, and see what no list names.
      if (!scratch.meetings[k])
        scratch.meetings[k] = next_meeting(prepared, line, inside, scratch.meeting, rays.mets);
    }
    scratch.found.resize(scratch.pending.size());
    next_meetings(prepared, sets, rays, scratch.pending, scratch.meeting, scratch.found);
    for (std::size_t p = 0; p < scratch.pending.size(); ++p)
      scratch.meetings[scratch.places[p]] = scratch.found[p];
    std::size_t left = 0;
    for (std::size_t k = 0; k < active.size(); ++k) {
      const std::size_t ray = active[k];
      if (!rays.in_gap[ray]) {
        const auto& meeting = scratch.meetings[k];
        if (!meeting || walk.leave_at(ray, *meeting)) continue;
      }
      if (!walk.enter(ray)) active[left++] = ray;
    }
    active.resize(left);
  }
}

} // namespace halftone::trace
