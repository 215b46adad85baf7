// Bodies that packets of lines enter and leave, and that stand between packets of points and a light, by the
// tests of bundle-inl.h (I. Wald et al., "Interactive rendering with coherent ray tracing", 2001), for each
// instruction set (Google Highway). The bodies listed for the packet are asked, or all, those whose ball none
// of its lines can meet excepted: lines of a ray tree's depth go everywhere, and up to about a hundred bodies
// that is faster than a walk through a hierarchy for each (docs/performance.md).
//
// Invariant: a line of which something is said has met what the scalar code says that it meets.

#include <halftone/geometry/packet.h>

#include <halftone/core/memory.h>

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "packet.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bundle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace halftone::geometry::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

/// What the lines of a bundle have met so far.
struct Nearest {
  V t, body, face;
  M ends, unsure;

  HWY_INLINE void offer(M meets, V at, V number, V on_face, M end) {
    const M nearer = hn::And(meets, hn::Lt(at, t)), farther = hn::Gt(at, t);
    unsure = hn::Or(unsure, and_not(and_not(meets, nearer), farther)); // at one distance, or not a number
    t = chosen(nearer, at, t);
    body = chosen(nearer, number, body);
    face = chosen(nearer, on_face, face);
    ends = hn::Or(and_not(ends, nearer), hn::And(end, nearer));
  }
};

void meet(const Packets& packets, const Packet& packet, std::span<const int> bodies, Meetings& meetings) {
  meetings.ends = meetings.unsure = 0;
  for (std::size_t from = 0; from < packet_size; from += hn::Lanes(Tag())) {
    const Bundle lines = bundle(packet, from);
    const V inside_a = load(meetings.inside[0], from), inside_b = load(meetings.inside[1], from);
    const auto are_in = [&](V number) { return hn::Or(hn::Eq(inside_a, number), hn::Eq(inside_b, number)); };
    Nearest nearest{all(infinity), all(-1), all(-1), none(), none()};
    if (any(hn::Or(hn::Ge(inside_a, all(0)),
                   hn::Ge(inside_b, all(0))))) { // ends first: nothing is asked beyond them
      for (const int body : bodies) {
        const V number = all(body);
        const M in = are_in(number);
        if (!any(in)) continue;
        const Exits exit = exits(packets, packets.table.parts[body], lines);
        nearest.offer(in, exit.t, number, exit.face, in);
      }
    }
    for (const int body : bodies) {
      V least;
      const V number = all(body);
      M near = may_meet(lines, packets.bounds[body], least);
      near = and_not(hn::And(near, hn::Le(least, nearest.t)), are_in(number));
      if (!any(near)) continue;
      const SolidTable::Parts& parts = packets.table.parts[body];
      if (parts.kind == scene::BodyKind::polygon) {
        const Crossings crossing = crossings(packets, parts, lines);
        nearest.unsure = hn::Or(nearest.unsure, hn::And(near, crossing.unsure));
        nearest.offer(hn::And(near, crossing.exist), crossing.t, number, all(0), none());
      } else {
        const Spans span = spans(packets, parts, lines, near);
        const M begins = and_not(span.exist, hn::Eq(span.in_surface, lines.surface));
        const V t = chosen(hn::Lt(span.in, all(0)), all(0), span.in);
        nearest.offer(begins, t, number, span.in_face, none());
      }
    }
    store(nearest.t, meetings.t, from);
    store(nearest.body, meetings.body, from);
    store(nearest.face, meetings.face, from);
    meetings.ends |= bits(nearest.ends, from);
    meetings.unsure |= bits(nearest.unsure, from);
  }
}

void shade(const Packets& packets, const Packet& packet, std::span<const int> opaque,
           std::span<const int> glass, Obstacles& obstacles) {
  obstacles.blocked = obstacles.unsure = 0;
  obstacles.glass.resize(glass.size());
  for (RunsIn& runs : obstacles.glass) runs.lines = 0;
  for (std::size_t from = 0; from < packet_size; from += hn::Lanes(Tag())) {
    const Bundle lines = bundle(packet, from);
    const V distance = load(obstacles.distance, from), own = load(obstacles.own, from);
    M blocked = none(), unsure = none();
    for (const int body : opaque) {
      if (hn::AllTrue(Tag(), blocked)) break;
      V least;
      M near = may_meet(lines, packets.bounds[body], least);
      near = and_not(and_not(near, blocked), hn::Eq(own, all(body)));
      if (!any(near)) continue;
      const SolidTable::Parts& parts = packets.table.parts[body];
      if (parts.kind == scene::BodyKind::polygon) {
        const Crossings crossing = crossings(packets, parts, lines);
        blocked = hn::Or(blocked, hn::And(hn::And(near, crossing.exist), hn::Lt(crossing.t, distance)));
        unsure = hn::Or(unsure, hn::And(near, crossing.unsure));
        continue;
      }
      // A span that reaches past the light ends at it, or begins there: trace/visibility.cpp says why.
      const Spans span = spans(packets, parts, lines, near);
      const M reaches = hn::Gt(span.out, distance);
      const V before = hn::Sub(distance, span.in), behind = hn::Sub(span.out, distance);
      const M begins = hn::And(reaches, hn::Or(hn::Le(before, all(0)), hn::Lt(before, behind)));
      const M stands = and_not(span.exist, hn::Or(begins, hn::Eq(span.in_surface, lines.surface)));
      const M counts = hn::Or(hn::Gt(span.in, all(0)), hn::Le(chosen(reaches, distance, span.out), distance));
      blocked = hn::Or(blocked, hn::And(stands, counts));
    }
    for (std::size_t g = 0; g < glass.size(); ++g) {
      V least;
      const M near = and_not(may_meet(lines, packets.bounds[glass[g]], least), blocked);
      if (!any(near)) continue;
      const Spans span = spans(packets, packets.table.parts[glass[g]], lines, near);
      RunsIn& runs = obstacles.glass[g];
      runs.lines |= bits(span.exist, from);
      store(span.in, runs.in, from);
      store(span.in_face, runs.in_face, from);
      store(span.out, runs.out, from);
      store(span.out_face, runs.out_face, from);
    }
    obstacles.blocked |= bits(blocked, from);
    obstacles.unsure |= bits(unsure, from);
  }
}

#endif

} // namespace halftone::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace halftone::geometry {

bool Packets::has(core::Simd simd) {
  switch (simd) {
  case core::Simd::avx512:
    return (HWY_TARGETS & HWY_AVX3) != 0;
  case core::Simd::avx2:
    return (HWY_TARGETS & HWY_AVX2) != 0;
  case core::Simd::baseline:
    break;
  }
  return false;
}

Packets::Packets(const Solids& solids, const Balls& balls, [[maybe_unused]] core::Simd simd)
    : table(solids.table) {
  for (std::size_t body = 0; body < table.parts.size(); ++body) bounds.push_back(balls.bound(body));
  for (std::size_t k = 0; k < table.planes.size(); ++k) {
    const SolidTable::PlaneSurface& on = table.plane_surfaces[k];
    planes.push_back({table.planes[k].normal, table.planes[k].offset, static_cast<double>(on.surface),
                      on.flipped ? -1.0 : 1.0});
  }
#if HWY_TARGETS & HWY_AVX3
  if (simd == core::Simd::avx512) {
    meet_ = N_AVX3::meet;
    shade_ = N_AVX3::shade;
  }
#endif
#if HWY_TARGETS & HWY_AVX2
  if (simd == core::Simd::avx2) {
    meet_ = N_AVX2::meet;
    shade_ = N_AVX2::shade;
  }
#endif
  assert(meet_ && shade_);
}

std::size_t Packets::memory() const { return core::memory_of(bounds) + core::memory_of(planes); }

} // namespace halftone::geometry

#endif
