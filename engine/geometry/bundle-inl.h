// A bundle of lines and a body: the tests of solids.cpp, quadric.cpp, shear.cpp and balls.cpp side by side,
// for the instruction set that packet.cpp is being compiled for.
//
// Invariant: the operations on a line are those of the scalar code in the same order, so results have the
// same bits (packet_test.cpp). No operation is contracted to a fused one.

// Read once for each instruction set, which HWY_TARGET_TOGGLE tells apart.
#if defined(HALFTONE_GEOMETRY_BUNDLE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef HALFTONE_GEOMETRY_BUNDLE_INL_H
#undef HALFTONE_GEOMETRY_BUNDLE_INL_H
#else
#define HALFTONE_GEOMETRY_BUNDLE_INL_H
#endif

#include <halftone/geometry/packet.h>

#include <halftone/core/rounding.h>
#include <halftone/core/vectors-inl.h>

#include <hwy/highway.h>

#include <limits>

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3

HWY_BEFORE_NAMESPACE();
namespace halftone::geometry::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using namespace core::HWY_NAMESPACE;
static_assert(packet_size % hn::MaxLanes(Tag()) == 0);

constexpr double infinity = std::numeric_limits<double>::infinity();

HWY_INLINE V load(const Numbers& numbers, std::size_t from) {
  return hn::Load(Tag(), numbers.at.data() + from);
}
HWY_INLINE void store(V value, Numbers& numbers, std::size_t from) {
  hn::Store(value, Tag(), numbers.at.data() + from);
}
HWY_INLINE Lines bits(M mask, std::size_t from) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return static_cast<Lines>(bytes[0]) << from;
}

/// The axis along which a line runs fastest, as in Shear.
struct Axes {
  M z_is_x, z_is_y;
  V per_z_x, per_z_y;

  HWY_INLINE V z(V3 v) const { return chosen(z_is_x, v.x, chosen(z_is_y, v.y, v.z)); }
  HWY_INLINE V x(V3 v) const { return chosen(z_is_x, v.y, chosen(z_is_y, v.z, v.x)); }
  HWY_INLINE V y(V3 v) const { return chosen(z_is_x, v.z, chosen(z_is_y, v.x, v.y)); }
};

/// Some lines of a packet, as many as a vector has.
struct Bundle {
  V3 origin, direction;
  V surface, outward;
  Axes axes;
};

HWY_INLINE Bundle bundle(const Packet& p, std::size_t from) {
  Bundle lines;
  lines.origin = {load(p.origin_x, from), load(p.origin_y, from), load(p.origin_z, from)};
  lines.direction = {load(p.direction_x, from), load(p.direction_y, from), load(p.direction_z, from)};
  lines.surface = load(p.surface, from);
  lines.outward = load(p.outward, from);
  const V3 size{hn::Abs(lines.direction.x), hn::Abs(lines.direction.y), hn::Abs(lines.direction.z)};
  const M x_over_y = hn::Gt(size.x, size.y);
  lines.axes.z_is_x = hn::And(x_over_y, hn::Gt(size.x, size.z));
  lines.axes.z_is_y = and_not(hn::Gt(size.y, size.z), x_over_y);
  const V z = lines.axes.z(lines.direction);
  lines.axes.per_z_x = hn::Div(lines.axes.x(lines.direction), z);
  lines.axes.per_z_y = hn::Div(lines.axes.y(lines.direction), z);
  return lines;
}

/// Balls::gather: lines that may meet the body, not before `from`.
HWY_INLINE M may_meet(const Bundle& lines, const Balls::Bound& ball, V& from) {
  const V3 to_center = minus(all(ball.center), lines.origin);
  const V along = dot(to_center, lines.direction);
  const V ahead = chosen(hn::Gt(along, all(0)), along, all(0));
  from = hn::Sub(hn::Mul(along, all(ball.nearer)), all(ball.before));
  const M missed = hn::Gt(hn::Mul(all(ball.kept), dot(to_center, to_center)),
                          hn::Add(all(ball.reach_squared), hn::Mul(ahead, ahead)));
  return hn::Not(missed);
}

struct Ranges {
  V in, out;
};

HWY_INLINE Ranges range_in(const scene::SphereSurface& sphere, const Bundle& lines) {
  const V3 to_center = minus(all(sphere.center), lines.origin);
  const V nearest = dot(to_center, lines.direction);
  const V3 apart = minus(to_center, times(lines.direction, nearest));
  const V half_squared = hn::Sub(all(sphere.radius * sphere.radius), dot(apart, apart));
  const M missed = hn::Lt(half_squared, all(0));
  const V half = hn::Sqrt(half_squared);
  return {chosen(missed, all(infinity), hn::Sub(nearest, half)),
          chosen(missed, all(-infinity), hn::Add(nearest, half))};
}

/// In a cone's frame: across the axis the line is at s and moves by p.
struct Framed {
  V sx, sy, px, py, radius, widening, a, gx, gy;
};

HWY_INLINE V difference_of_products(V a, V b, V c, V d) { return hn::Sub(hn::Mul(a, b), hn::Mul(c, d)); }
HWY_INLINE V sum_of_products(V a, V b, V c, V d) { return hn::Add(hn::Mul(a, b), hn::Mul(c, d)); }

HWY_INLINE Ranges by_distance(const Framed& f) {
  const V b = hn::Sub(sum_of_products(f.sx, f.px, f.sy, f.py), hn::Mul(f.radius, f.widening));
  const V turn = difference_of_products(f.sx, f.py, f.sy, f.px);
  const V discriminant = hn::Sub(sum_of_products(f.gx, f.gx, f.gy, f.gy), hn::Mul(turn, turn));
  const M missed = hn::Or(hn::Lt(discriminant, all(0)),
                          hn::Lt(hn::Sub(f.radius, hn::Mul(f.widening, hn::Div(b, f.a))), all(0)));
  const V root = hn::Sqrt(discriminant);
  const M along = hn::Eq(f.a, all(0)); // a cylinder
  const M outside = hn::Gt(sum_of_products(f.sx, f.sx, f.sy, f.sy), hn::Mul(f.radius, f.radius));
  const M nowhere = hn::Or(hn::And(along, outside), and_not(missed, along));
  const V in = chosen(along, all(-infinity), hn::Div(hn::Neg(hn::Add(b, root)), f.a));
  const V out = chosen(along, all(infinity), hn::Div(hn::Sub(root, b), f.a));
  return {chosen(nowhere, all(infinity), in), chosen(nowhere, all(-infinity), out)};
}

HWY_INLINE Ranges by_radius(const Framed& f) {
  const V b = sum_of_products(f.gx, f.px, f.gy, f.py), c = sum_of_products(f.gx, f.gx, f.gy, f.gy);
  const V turn = difference_of_products(f.gx, f.py, f.gy, f.px);
  const V discriminant = hn::Sub(hn::Mul(hn::Mul(f.widening, f.widening), c), hn::Mul(turn, turn));
  const M negative = hn::Lt(discriminant, all(0));
  const M widens = hn::Gt(f.widening, all(0));
  const M one_nappe = hn::Ge(f.a, all(0));
  const V root = hn::Sqrt(chosen(hn::And(negative, hn::Not(one_nappe)), all(0), discriminant));
  const V q = hn::Add(b, chosen(one_nappe, root, hn::CopySign(root, b)));
  const V near_apex = hn::Div(hn::Sub(hn::Div(c, q), f.radius), f.widening);
  const V away = hn::Div(hn::Sub(hn::Div(q, f.a), f.radius), f.widening);
  const M nowhere = hn::And(one_nappe, hn::Or(negative, hn::Not(hn::Gt(b, all(0)))));
  const V only = chosen(hn::Gt(q, all(0)), near_apex, away); // on our nappe, where there is one on each
  const V in = chosen(one_nappe, chosen(widens, near_apex, away), chosen(widens, only, all(-infinity)));
  const V out = chosen(one_nappe, chosen(widens, away, near_apex), chosen(widens, all(infinity), only));
  return {chosen(nowhere, all(infinity), in), chosen(nowhere, all(-infinity), out)};
}

HWY_INLINE Ranges range_in(const FramedCone& cone, const Bundle& lines) {
  const V3 from_origin = minus(lines.origin, all(cone.origin));
  const V shift = hn::Neg(dot(from_origin, lines.direction));
  const V3 start = plus(from_origin, times(lines.direction, shift));
  const V3 u = all(cone.u), v = all(cone.v), axis = all(cone.axis);
  const V slope = all(cone.slope);
  Framed f{dot(start, u),
           dot(start, v),
           dot(lines.direction, u),
           dot(lines.direction, v),
           hn::Add(all(cone.radius), hn::Mul(slope, dot(start, axis))),
           hn::Mul(slope, dot(lines.direction, axis)),
           all(0),
           all(0),
           all(0)};
  const V across = sum_of_products(f.px, f.px, f.py, f.py), grown = hn::Mul(f.widening, f.widening);
  f.a = hn::Sub(across, grown);
  f.gx = difference_of_products(f.radius, f.px, f.widening, f.sx);
  f.gy = difference_of_products(f.radius, f.py, f.widening, f.sy);
  const M is_steep = hn::Gt(hn::Mul(all(4), grown), across);
  Ranges range = by_distance(f);
  if (any(is_steep)) {
    const Ranges steep = by_radius(f);
    range = {chosen(is_steep, steep.in, range.in), chosen(is_steep, steep.out, range.out)};
  }
  return {hn::Add(shift, range.in), hn::Add(shift, range.out)};
}

/// The round side of a sphere or a frustum.
HWY_INLINE Ranges round_ranges(const SolidTable& table, const SolidTable::Parts& parts, const Bundle& lines) {
  const Ranges range = parts.kind == scene::BodyKind::sphere ? range_in(table.spheres[parts.round], lines)
                                                             : range_in(table.cones[parts.round], lines);
  const M starts = hn::Eq(lines.surface, all(parts.round_surface)), leaves = hn::Gt(lines.outward, all(0));
  const V in_before = chosen(hn::Lt(all(0), range.in), all(0), range.in);
  const V out_behind = chosen(hn::Lt(range.out, all(0)), all(0), range.out);
  return {chosen(starts, chosen(leaves, in_before, all(0)), range.in),
          chosen(starts, chosen(leaves, all(0), out_behind), range.out)};
}

/// How lines pass a plane: positive approach is on their way out.
struct Passes {
  V approach, depth, surface;
};

HWY_INLINE Passes passes(const Packets::Plane& plane, const Bundle& lines) {
  const V3 normal = all(plane.normal);
  const V surface = all(plane.surface);
  const M starts = hn::Eq(lines.surface, surface);
  return {chosen(starts, hn::Mul(lines.outward, all(plane.sense)), dot(normal, lines.direction)),
          chosen(starts, all(0), hn::Sub(all(plane.offset), dot(normal, lines.origin))), surface};
}

HWY_INLINE int first_flat_face(const SolidTable::Parts& parts) {
  return parts.kind == scene::BodyKind::frustum ? 1 : 0;
}

/// Where lines that are in a solid leave it.
struct Exits {
  V t, face;
};

HWY_INLINE Exits exits(const Packets& packets, const SolidTable::Parts& parts, const Bundle& lines) {
  Exits exit{parts.round >= 0 ? round_ranges(packets.table, parts, lines).out : all(infinity), all(0)};
  V face = all(first_flat_face(parts));
  for (int k = parts.first; k < parts.first + parts.count; ++k) {
    const Passes pass = passes(packets.planes[k], lines);
    const V t = hn::Div(pass.depth, pass.approach);
    const M sooner = hn::And(hn::Gt(pass.approach, all(0)), hn::Lt(t, exit.t));
    exit.t = chosen(sooner, t, exit.t);
    exit.face = chosen(sooner, face, exit.face);
    face = hn::Add(face, all(1));
  }
  const M stays = hn::And(hn::Lt(exit.t, all(infinity)), hn::Ge(exit.t, all(0)));
  exit.t = chosen(stays, exit.t, all(0));
  return exit;
}

/// Where some of the lines run in a solid.
struct Spans {
  V in, in_face, in_surface, out, out_face;
  M exist;
};

HWY_INLINE Spans spans(const Packets& packets, const SolidTable::Parts& parts, const Bundle& lines, M some) {
  Spans span{all(-infinity), all(-1), all(-1), all(infinity), all(-1), some};
  if (parts.round >= 0) {
    const Ranges range = round_ranges(packets.table, parts, lines);
    span.exist = and_not(some, hn::Or(hn::Ge(range.in, range.out), hn::Le(range.out, all(0))));
    const M begins = hn::Gt(range.in, all(-infinity)), ends = hn::Lt(range.out, all(infinity));
    span.in = chosen(begins, range.in, all(-infinity));
    span.in_face = chosen(begins, all(0), all(-1));
    span.in_surface = all(parts.round_surface);
    span.out = chosen(ends, range.out, all(infinity));
    span.out_face = chosen(ends, all(0), all(-1));
  }
  V face = all(first_flat_face(parts));
  for (int k = parts.first; k < parts.first + parts.count && any(span.exist); ++k) {
    const Passes pass = passes(packets.planes[k], lines);
    const V t = hn::Div(pass.depth, pass.approach);
    const M enters = hn::Lt(pass.approach, all(0)), behind = hn::Gt(pass.depth, all(0));
    const M later = hn::And(enters, hn::Gt(t, span.in));
    span.in = chosen(later, t, span.in);
    span.in_face = chosen(later, face, span.in_face);
    span.in_surface = chosen(later, pass.surface, span.in_surface);
    const M sooner = hn::And(hn::And(hn::Gt(pass.approach, all(0)), behind), hn::Lt(t, span.out));
    span.out = chosen(sooner, t, span.out);
    span.out_face = chosen(sooner, face, span.out_face);
    span.exist = hn::And(span.exist, hn::Or(enters, behind));
    face = hn::Add(face, all(1));
  }
  const M bounded = hn::And(hn::Ge(span.in_face, all(0)), hn::Ge(span.out_face, all(0)));
  span.exist = and_not(hn::And(span.exist, bounded), hn::Ge(span.in, span.out));
  return span;
}

struct Crossings {
  V t;
  M exist, unsure;
};

HWY_INLINE Crossings crossings(const Packets& packets, const SolidTable::Parts& parts, const Bundle& lines) {
  const Packets::Plane& plane = packets.planes[parts.first];
  const V3 normal = all(plane.normal);
  const V t = hn::Div(hn::Sub(all(plane.offset), dot(normal, lines.origin)), dot(normal, lines.direction));
  M exist = hn::And(hn::Gt(t, all(0)), hn::Lt(t, all(infinity)));
  exist = and_not(exist, hn::Eq(lines.surface, all(plane.surface)));
  Crossings crossing{t, exist, none()};
  if (!any(exist)) return crossing;
  const auto sheared = [&](int corner, V& x, V& y, V& along) {
    const V3 from = minus(all(packets.table.corners[corner]), lines.origin);
    const V z = lines.axes.z(from);
    x = hn::Sub(lines.axes.x(from), hn::Mul(lines.axes.per_z_x, z));
    y = hn::Sub(lines.axes.y(from), hn::Mul(lines.axes.per_z_y, z));
    along = dot(from, lines.direction);
  };
  V from_x, from_y, along, nearest = all(infinity), farthest = all(-infinity);
  sheared(parts.corner + parts.corners - 1, from_x, from_y, along);
  M inside = none();
  for (int k = parts.corner; k < parts.corner + parts.corners; ++k) {
    V x, y;
    sheared(k, x, y, along);
    nearest = chosen(hn::Lt(along, nearest), along, nearest);
    farthest = chosen(hn::Lt(farthest, along), along, farthest);
    const M is_under = hn::Le(from_y, all(0));
    const M changes = hn::Xor(is_under, hn::Le(y, all(0)));
    const V p = hn::Mul(from_x, y), q = hn::Mul(from_y, x);
    const M turns = hn::Or(hn::And(is_under, hn::Gt(p, q)), and_not(hn::Gt(q, p), is_under));
    inside = hn::Xor(inside, hn::And(changes, turns));
    crossing.unsure = hn::Or(crossing.unsure, hn::And(changes, hn::Eq(p, q)));
    from_x = x, from_y = y;
  }
  crossing.unsure = hn::And(crossing.unsure, exist);
  const V margin =
      hn::Mul(all(core::gamma(16)), hn::Add(all(parts.reach), hn::Sqrt(dot(lines.origin, lines.origin))));
  const M beyond = hn::Gt(t, hn::Add(farthest, margin)), before = hn::Lt(t, hn::Sub(nearest, margin));
  crossing.t = chosen(beyond, farthest, chosen(before, nearest, t));
  exist = hn::And(exist, inside);
  crossing.exist = and_not(exist, hn::And(beyond, hn::Not(hn::Gt(farthest, all(0)))));
  return crossing;
}

} // namespace halftone::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

#endif
