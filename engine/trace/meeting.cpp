// Nested dielectrics by sets of solids (C. Schmidt and B. Budge, "Simple nested dielectrics in ray traced
// images", 2002) without an epsilon: a ray that is in a solid meets its exit and nothing else of it, and what
// begins on the surface that a ray starts on has been met already. Surfaces that coincide have one t, to the
// bit.
//
// Invariant: the meeting does not depend on the order in which bodies are asked.

#include "meeting.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace halftone::trace {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Keeps the events at the nearest distance.
struct Nearest {
  double t = infinity;
  std::vector<Event>& events;

  explicit Nearest(MeetingScratch& scratch) : events(scratch.events) { events.clear(); }

  void offer(double distance, const Event& event) {
    if (distance > t) return;
    if (distance < t) events.clear();
    t = distance;
    events.push_back(event);
  }
};

bool is_in(std::span<const int> inside, int body) {
  return std::find(inside.begin(), inside.end(), body) != inside.end();
}

Event event_at(const Prepared& prepared, EventKind kind, int body, int face) {
  return {kind, {body, face}, prepared.world.bodies[body].faces[face].surface};
}

/// Of a body that the ray is not in.
EventKind entry_kind(const Prepared& prepared, int body) {
  return prepared.media[body].is_glass ? EventKind::entry : EventKind::opaque;
}

/// Of a solid that the ray is in.
EventKind exit_kind(const Prepared& prepared, int body) {
  return prepared.media[body].is_glass ? EventKind::exit : EventKind::wall;
}

/// The exit of a solid that the ray is in.
void offer_exit(const Prepared& prepared, const geometry::Line& line, int body, Nearest& nearest) {
  const geometry::Crossing out = prepared.solids.exit(body, line);
  nearest.offer(out.t, event_at(prepared, exit_kind(prepared, body), body, out.face));
}

/// Where the ray meets a body that it is not in.
void offer_entry(const Prepared& prepared, const geometry::Line& line, int body, Nearest& nearest) {
  if (prepared.is_polygon(body)) {
    if (const auto crossing = prepared.solids.crossing(body, line))
      nearest.offer(crossing->t, event_at(prepared, EventKind::opaque, body, crossing->face));
    return;
  }
  const auto span = prepared.solids.span(body, line);
  if (!span) return;
  const Event event = event_at(prepared, entry_kind(prepared, body), body, span->in.face);
  // Whatever begins on the surface that the ray starts on was met when the ray got there.
  if (event.surface != line.surface) nearest.offer(std::max(span->in.t, 0.0), event);
}

/// Where opaque surfaces coincide, a wall hides what touches it from outside; then a polygon is seen before a
/// solid, otherwise the one last in the file.
bool is_seen_before(const Prepared& prepared, const Event& a, const Event& b) {
  if ((a.kind == EventKind::wall) != (b.kind == EventKind::wall)) return a.kind == EventKind::wall;
  const bool a_flat = prepared.is_polygon(a.met.body), b_flat = prepared.is_polygon(b.met.body);
  return a_flat != b_flat ? a_flat : a.met.body > b.met.body;
}

/// Events on one surface, by kind: exits behind, the others ahead.
Gap sorted(const Prepared& prepared, std::span<const Event> events, Mets& mets) {
  Gap gap;
  const Event* opaque = nullptr;
  gap.behind.first = static_cast<int>(mets.size());
  for (const Event& event : events)
    if (event.kind == EventKind::exit) mets.push_back(event.met);
  gap.ahead.first = static_cast<int>(mets.size());
  gap.behind.count = gap.ahead.first - gap.behind.first;
  for (const Event& event : events) {
    if (event.kind == EventKind::entry)
      mets.push_back(event.met);
    else if (event.kind != EventKind::exit && (!opaque || is_seen_before(prepared, event, *opaque)))
      opaque = &event;
  }
  gap.ahead.count = static_cast<int>(mets.size()) - gap.ahead.first;
  if (opaque) gap.ahead.opaque = opaque->met;
  return gap;
}

/// A quadric is left where a solid ends and entered where one begins, whatever rounding says at grazing
/// angles.
bool is_outward(const Prepared& prepared, const Vec3& direction, int surface, bool ends) {
  if (const auto* plane = std::get_if<scene::Plane>(&prepared.world.surfaces[surface]))
    return glm::dot(plane->normal, direction) > 0;
  return ends;
}

bool is_end(EventKind kind) { return kind == EventKind::exit || kind == EventKind::wall; }

/// Where nothing else is met at that distance, as nearly everywhere; inline for g++, as is `add` in
/// branch.cpp.
inline Meeting meeting_with(const Prepared& prepared, const Vec3& direction, double t, const Event& event,
                            Mets& mets) {
  Gap gap;
  if (event.kind == EventKind::exit || event.kind == EventKind::entry) {
    Touching& side = event.kind == EventKind::exit ? gap.behind : gap.ahead;
    side.first = static_cast<int>(mets.size());
    side.count = 1;
    mets.push_back(event.met);
  } else {
    gap.ahead.opaque = event.met;
  }
  return {t, event.surface, is_outward(prepared, direction, event.surface, is_end(event.kind)), gap};
}

std::optional<Meeting> meeting_of(const Prepared& prepared, const Vec3& direction, const Nearest& nearest,
                                  Mets& mets) {
  std::vector<Event>& events = nearest.events;
  if (events.empty()) return std::nullopt;
  if (events.size() == 1) return meeting_with(prepared, direction, nearest.t, events[0], mets);
  // At one distance but on several surfaces, one of them comes first; the others are met in the next step.
  std::sort(events.begin(), events.end(),
            [](const Event& a, const Event& b) { return a.met.body < b.met.body; });
  const Event first = *std::min_element(events.begin(), events.end(),
                                        [](const Event& a, const Event& b) { return a.kind < b.kind; });
  std::erase_if(events, [&](const Event& event) { return event.surface != first.surface; });
  const bool ends =
      std::any_of(events.begin(), events.end(), [](const Event& event) { return is_end(event.kind); });
  return Meeting{nearest.t, first.surface, is_outward(prepared, direction, first.surface, ends),
                 sorted(prepared, events, mets)};
}

} // namespace

std::optional<Meeting> next_meeting(const Prepared& prepared, const geometry::Line& line,
                                    std::span<const int> inside, MeetingScratch& scratch, Mets& mets) {
  Nearest nearest(scratch);
  for (const int body : inside) offer_exit(prepared, line, body, nearest);
  if (prepared.tree) {
    prepared.tree->along({line.origin, line.direction}, nearest.t, [&](int body) {
      ++scratch.comparisons;
      if (!is_in(inside, body) && prepared.balls.may_meet(body, line))
        offer_entry(prepared, line, body, nearest);
      return nearest.t;
    });
  } else {
    scratch.comparisons += prepared.world.bodies.size();
    for (const geometry::Near& near : prepared.balls.gather(line, scratch.near))
      if (near.from <= nearest.t && !is_in(inside, near.body))
        offer_entry(prepared, line, near.body, nearest);
  }
  return meeting_of(prepared, line.direction, nearest, mets);
}

std::optional<Meeting> next_meeting(const Prepared& prepared, const geometry::Line& line,
                                    std::span<const int> inside, std::span<const int> candidates,
                                    MeetingScratch& scratch, Mets& mets) {
  Nearest nearest(scratch);
  scratch.comparisons += candidates.size();
  for (const int body : candidates) {
    if (is_in(inside, body))
      offer_exit(prepared, line, body, nearest);
    else if (prepared.balls.may_meet(body, line))
      offer_entry(prepared, line, body, nearest);
  }
  return meeting_of(prepared, line.direction, nearest, mets);
}

namespace {

std::optional<Meeting> meeting_alone(const Prepared& prepared, const InsideSets& sets, const Ray& ray,
                                     std::span<const int> candidates, MeetingScratch& scratch, Mets& mets) {
  const auto inside = sets.bodies(ray.inside);
  if (candidates.empty()) return next_meeting(prepared, ray.line(), inside, scratch, mets);
  return next_meeting(prepared, ray.line(), inside, candidates, scratch, mets);
}

/// Up to packet_size rays at once. Those of which the packet is not sure are asked again one by one.
void next_meetings_together(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
                            std::span<const std::size_t> some, std::span<const int> candidates,
                            MeetingScratch& scratch, Mets& mets, std::span<std::optional<Meeting>> meetings) {
  geometry::Packet& packet = scratch.packet;
  geometry::Meetings& met = scratch.met;
  geometry::Lines unsure = 0;
  for (std::size_t k = 0; k < geometry::packet_size; ++k) {
    const Ray& ray = rays[some[std::min(k, some.size() - 1)]];
    const auto inside = sets.bodies(ray.inside);
    packet.set(k, ray.line());
    for (std::size_t i = 0; i < std::size(met.inside); ++i)
      met.inside[i][k] = i < inside.size() ? inside[i] : -1;
    if (inside.size() > std::size(met.inside) || (ray.at_eye && prepared.eye_in_plane)) unsure |= 1u << k;
  }
  const std::span<const int> bodies = candidates.empty() ? prepared.all_bodies : candidates;
  prepared.packets->meet(packet, bodies, met);
  unsure |= met.unsure;
  for (std::size_t k = 0; k < some.size(); ++k) {
    const Ray& ray = rays[some[k]];
    if (unsure >> k & 1) {
      meetings[k] = meeting_alone(prepared, sets, ray, candidates, scratch, mets);
      continue;
    }
    scratch.comparisons += bodies.size();
    const int body = static_cast<int>(met.body[k]), face = static_cast<int>(met.face[k]);
    if (body < 0) {
      meetings[k].reset();
      continue;
    }
    const EventKind kind = met.ends >> k & 1 ? exit_kind(prepared, body) : entry_kind(prepared, body);
    meetings[k] = meeting_with(prepared, ray.direction, met.t[k], event_at(prepared, kind, body, face), mets);
  }
}

} // namespace

void next_meetings(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
                   std::span<const std::size_t> some, std::span<const int> candidates,
                   MeetingScratch& scratch, Mets& mets, std::span<std::optional<Meeting>> meetings) {
  if (!prepared.packets || (candidates.empty() && prepared.tree)) {
    for (std::size_t k = 0; k < some.size(); ++k)
      meetings[k] = meeting_alone(prepared, sets, rays[some[k]], candidates, scratch, mets);
    return;
  }
  for (std::size_t first = 0; first < some.size(); first += geometry::packet_size) {
    const std::size_t count = std::min(geometry::packet_size, some.size() - first);
    next_meetings_together(prepared, sets, rays, some.subspan(first, count), candidates, scratch, mets,
                           meetings.subspan(first, count));
  }
}

Touching touching(const Prepared& prepared, const geometry::Line& line, MeetingScratch& scratch, Mets& mets) {
  std::vector<Event>& beginning = scratch.events;
  beginning.clear();
  const auto look_at = [&](int body) {
    if (prepared.is_polygon(body)) return;
    const auto span = prepared.solids.span(body, line);
    if (!span) return;
    const Event event = event_at(prepared, entry_kind(prepared, body), body, span->in.face);
    if (event.surface == line.surface) beginning.push_back(event);
  };
  if (prepared.tree) {
    prepared.tree->along({line.origin, line.direction}, infinity, [&](int body) {
      look_at(body);
      return infinity;
    });
    std::sort(beginning.begin(), beginning.end(),
              [](const Event& a, const Event& b) { return a.met.body < b.met.body; });
  } else {
    for (const geometry::Near& near : prepared.balls.gather(line, scratch.near)) look_at(near.body);
  }
  return sorted(prepared, beginning, mets).ahead;
}

} // namespace halftone::trace
