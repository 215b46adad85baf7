// Bodies that packets of lines enter, and that stand between packets of points and a light, by the tests of
// bundle-inl.h (I. Wald et al., "Interactive rendering with coherent ray tracing", 2001), for each
// instruction set (Google Highway). All bodies are asked, those whose ball no line of the packet can meet
// excepted: lines of a ray tree's depth go everywhere, and up to some fifty bodies that is faster than a walk
// through a hierarchy for each (docs/performance.md).
//
// Invariant: a line of which something is said has met what the scalar code says that it meets.

#include <halftone/geometry/packet.h>

#include <cassert>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "packet.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bundle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace halftone::geometry::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

void enter(const Packets& packets, const Packet& packet, Entries& entries) {
  entries.unsure = 0;
  for (std::size_t from = 0; from < packet_size; from += hn::Lanes(Tag())) {
    const Bundle lines = bundle(packet, from);
    const V inside_a = load(entries.inside[0], from), inside_b = load(entries.inside[1], from);
    V nearest = load(entries.t, from), nearest_body = all(-1), nearest_face = all(-1);
    M unsure = none();
    for (std::size_t body = 0; body < packets.bounds.size(); ++body) {
      V least;
      const V number = all(static_cast<double>(body));
      M near = may_meet(lines, packets.bounds[body], least);
      near = hn::And(near, hn::Le(least, nearest));
      near = and_not(near, hn::Or(hn::Eq(inside_a, number), hn::Eq(inside_b, number)));
      if (!any(near)) continue;
      const SolidTable::Parts& parts = packets.table.parts[body];
      V t, face = all(0);
      M meets;
      if (parts.kind == scene::BodyKind::polygon) {
        const Crossings crossing = crossings(packets.table, parts, lines);
        t = crossing.t;
        meets = hn::And(near, crossing.exist);
        unsure = hn::Or(unsure, hn::And(near, crossing.unsure));
      } else {
        const Spans span = spans(packets.table, parts, lines);
        t = chosen(hn::Lt(span.in, all(0)), all(0), span.in);
        face = span.in_face;
        meets = hn::And(near, and_not(span.exist, hn::Eq(span.in_surface, lines.surface)));
      }
      const M nearer = hn::And(meets, hn::Lt(t, nearest)), farther = hn::Gt(t, nearest);
      unsure = hn::Or(unsure, and_not(and_not(meets, nearer), farther)); // at one distance, or not a number
      nearest = chosen(nearer, t, nearest);
      nearest_body = chosen(nearer, number, nearest_body);
      nearest_face = chosen(nearer, face, nearest_face);
    }
    store(nearest, entries.t, from);
    store(nearest_body, entries.body, from);
    store(nearest_face, entries.face, from);
    entries.unsure |= bits(unsure, from);
  }
}

void shade(const Packets& packets, const Packet& packet, std::span<const int> opaque,
           std::span<const int> glass, Obstacles& obstacles) {
  obstacles.blocked = obstacles.unsure = 0;
  obstacles.glass.assign(glass.size(), 0);
  for (std::size_t from = 0; from < packet_size; from += hn::Lanes(Tag())) {
    const Bundle lines = bundle(packet, from);
    const V distance = load(obstacles.distance, from), own = load(obstacles.own, from);
    M blocked = none(), unsure = none();
    for (const int body : opaque) {
      V least;
      M near = may_meet(lines, packets.bounds[body], least);
      near = and_not(and_not(near, blocked), hn::Eq(own, all(body)));
      if (!any(near)) continue;
      const SolidTable::Parts& parts = packets.table.parts[body];
      if (parts.kind == scene::BodyKind::polygon) {
        const Crossings crossing = crossings(packets.table, parts, lines);
        blocked = hn::Or(blocked, hn::And(hn::And(near, crossing.exist), hn::Lt(crossing.t, distance)));
        unsure = hn::Or(unsure, hn::And(near, crossing.unsure));
        continue;
      }
      // A span that reaches past the light ends at it, or begins there: trace/visibility.cpp says why.
      const Spans span = spans(packets.table, parts, lines);
      const M reaches = hn::Gt(span.out, distance);
      const V before = hn::Sub(distance, span.in), behind = hn::Sub(span.out, distance);
      const M begins = hn::And(reaches, hn::Or(hn::Le(before, all(0)), hn::Lt(before, behind)));
      const M stands = and_not(span.exist, hn::Or(begins, hn::Eq(span.in_surface, lines.surface)));
      const M counts = hn::Or(hn::Gt(span.in, all(0)), hn::Le(chosen(reaches, distance, span.out), distance));
      blocked = hn::Or(blocked, hn::And(near, hn::And(stands, counts)));
    }
    for (std::size_t g = 0; g < glass.size(); ++g) {
      V least;
      const M near = and_not(may_meet(lines, packets.bounds[glass[g]], least), blocked);
      if (!any(near)) continue;
      const Spans span = spans(packets.table, packets.table.parts[glass[g]], lines);
      obstacles.glass[g] |= bits(hn::And(near, span.exist), from);
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

Packets::Packets(const Solids& solids, const Balls& balls, core::Simd simd) : table(solids.table) {
  for (std::size_t body = 0; body < table.parts.size(); ++body) bounds.push_back(balls.bound(body));
#if HWY_TARGETS & HWY_AVX3
  if (simd == core::Simd::avx512) {
    enter_ = N_AVX3::enter;
    shade_ = N_AVX3::shade;
  }
#endif
#if HWY_TARGETS & HWY_AVX2
  if (simd == core::Simd::avx2) {
    enter_ = N_AVX2::enter;
    shade_ = N_AVX2::shade;
  }
#endif
  assert(enter_ && shade_);
}

} // namespace halftone::geometry

#endif
