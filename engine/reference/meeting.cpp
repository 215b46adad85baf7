#include "meeting.h"

#include <algorithm>
#include <limits>

namespace halftone::reference {

namespace {

/// In the order in which surfaces at one distance are met. A wall is the far side of an opaque solid that the
/// eye is in.
enum class Event { exit, wall, opaque, entry };

struct Candidate {
  double t = std::numeric_limits<double>::infinity();
  Event event = Event::entry;
  Met met;
  int surface = -1;
};

bool is_glass(const World& world, int body) {
  return world.materials[world.bodies[body].material].glass.has_value();
}

/// The next crossing of one body by a ray, if there is one ahead.
std::optional<Candidate> candidate(const World& world, int index, const Line& line, const Inside& inside) {
  const Body& body = world.bodies[index];
  const auto found = [&](const Crossing& crossing, Event event) {
    return Candidate{crossing.t, event, {index, crossing.face}, body.faces[crossing.face].surface};
  };
  if (body.kind == scene::BodyKind::polygon) {
    const auto crossing = cross(world, body, line);
    if (!crossing) return std::nullopt;
    return found(*crossing, Event::opaque);
  }
  if (is_in(inside, index))
    return found(exit(world, body, line), is_glass(world, index) ? Event::exit : Event::wall);
  const auto span = cut(world, body, line);
  if (!span || span->out.t <= 0) return std::nullopt;
  return found({std::max(span->in.t, 0.0), span->in.face},
               is_glass(world, index) ? Event::entry : Event::opaque);
}

/// Where opaque surfaces coincide, a wall hides what touches it from outside; then a polygon is seen before a
/// solid, otherwise the one last in the file.
bool is_seen_before(const World& world, const Candidate& a, const Candidate& b) {
  if ((a.event == Event::wall) != (b.event == Event::wall)) return a.event == Event::wall;
  const bool a_flat = world.bodies[a.met.body].kind == scene::BodyKind::polygon;
  const bool b_flat = world.bodies[b.met.body].kind == scene::BodyKind::polygon;
  return a_flat != b_flat ? a_flat : a.met.body > b.met.body;
}

/// Candidates at one distance on one surface, by kind.
Meeting sorted(const World& world, const std::vector<Candidate>& candidates) {
  Meeting meeting;
  const Candidate* opaque = nullptr;
  for (const Candidate& c : candidates) {
    if (c.event == Event::exit)
      meeting.exits.push_back(c.met);
    else if (c.event == Event::entry)
      meeting.ahead.entries.push_back(c.met);
    else if (!opaque || is_seen_before(world, c, *opaque))
      opaque = &c;
  }
  if (opaque) meeting.ahead.opaque = opaque->met;
  return meeting;
}

} // namespace

bool is_in(const Inside& inside, int body) { return std::binary_search(inside.begin(), inside.end(), body); }

Inside without(const Inside& inside, const std::vector<Met>& exits) {
  Inside rest;
  for (const int body : inside)
    if (std::none_of(exits.begin(), exits.end(), [&](const Met& met) { return met.body == body; }))
      rest.push_back(body);
  return rest;
}

Inside with(const Inside& inside, const std::vector<Met>& entries) {
  Inside all = inside;
  for (const Met& met : entries) all.insert(std::lower_bound(all.begin(), all.end(), met.body), met.body);
  return all;
}

Inside solids_around(const World& world, const Vec3& point) {
  Inside inside;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b)
    if (world.bodies[b].kind != scene::BodyKind::polygon && contains(world, world.bodies[b], point))
      inside.push_back(b);
  return inside;
}

int medium(const World& world, const Inside& inside) {
  for (auto body = inside.rbegin(); body != inside.rend(); ++body)
    if (is_glass(world, *body)) return *body;
  return -1;
}

Touching touching(const World& world, const Line& line) {
  std::vector<Candidate> beginning;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const Body& body = world.bodies[b];
    if (body.kind == scene::BodyKind::polygon) continue;
    const auto span = cut(world, body, line);
    if (span && span->out.t > 0 && body.faces[span->in.face].surface == line.surface)
      beginning.push_back(
          {0, is_glass(world, b) ? Event::entry : Event::opaque, {b, span->in.face}, line.surface});
  }
  return sorted(world, beginning).ahead;
}

std::optional<Meeting> next_meeting(const World& world, const Line& line, const Inside& inside) {
  Candidate nearest;
  std::vector<Candidate> candidates;
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const auto next = candidate(world, b, line, inside);
    if (!next || next->t > nearest.t) continue;
    candidates.push_back(*next);
    if (next->t < nearest.t || next->event < nearest.event) nearest = *next;
  }
  if (nearest.surface < 0) return std::nullopt;

  std::erase_if(candidates,
                [&](const Candidate& c) { return c.t != nearest.t || c.surface != nearest.surface; });
  Meeting meeting = sorted(world, candidates);
  meeting.t = nearest.t;
  meeting.surface = nearest.surface;
  // A quadric is left where a solid ends and entered where one begins, whatever rounding says at grazing
  // angles.
  if (const auto* plane = std::get_if<scene::Plane>(&world.surfaces[nearest.surface]))
    meeting.outward = glm::dot(plane->normal, line.direction) > 0;
  else
    meeting.outward = nearest.event == Event::exit || nearest.event == Event::wall;
  return meeting;
}

} // namespace halftone::reference
