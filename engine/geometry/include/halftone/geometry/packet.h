#pragma once
// Line ∩ body for eight lines at once, by the processor's vectors. What Solids and Balls say of one line, to
// the bit; where that takes exact signs, or several bodies are met at one distance, the line is `unsure`, and
// has to be asked there.

#include <halftone/core/simd.h>
#include <halftone/geometry/balls.h>
#include <halftone/geometry/solids.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace halftone::geometry {

inline constexpr std::size_t packet_size = 8;

/// One number for each line.
struct alignas(64) Numbers {
  std::array<double, packet_size> at{};

  double& operator[](std::size_t k) { return at[k]; }
  double operator[](std::size_t k) const { return at[k]; }
};

/// Lines; none that starts at the eye (Line::at_eye) where that lies in the plane of a face. Places without a
/// line repeat one of the others.
struct Packet {
  Numbers origin_x, origin_y, origin_z;
  Numbers direction_x, direction_y, direction_z;
  Numbers surface; ///< index into World::surfaces, or -1
  Numbers outward; ///< 1 or -1

  void set(std::size_t k, const Line& line) {
    origin_x[k] = line.origin.x, origin_y[k] = line.origin.y, origin_z[k] = line.origin.z;
    direction_x[k] = line.direction.x, direction_y[k] = line.direction.y, direction_z[k] = line.direction.z;
    surface[k] = line.surface;
    outward[k] = line.outward ? 1 : -1;
  }
};

/// One bit for each line.
using Lines = std::uint32_t;

/// What each line meets first: the end of a body that it is in, as a fact, or a body that it is not in.
struct Meetings {
  Numbers inside[2]; ///< in: bodies that the line is in, or -1
  Numbers t;
  Numbers body; ///< -1: nothing is met
  Numbers face;
  Lines ends = 0;   ///< lines that are in that body
  Lines unsure = 0; ///< lines of which nothing else is known
};

/// Where the lines run in a solid, as Span has it.
struct RunsIn {
  Lines lines = 0; ///< those that do
  Numbers in, in_face, out, out_face;

  Span operator[](std::size_t k) const {
    return {{in[k], static_cast<int>(in_face[k])}, {out[k], static_cast<int>(out_face[k])}};
  }
};

/// What stands between each line's origin and a light.
struct Obstacles {
  Numbers distance;          ///< in: of the light
  Numbers own;               ///< in: the body that the line starts on
  Lines blocked = 0;         ///< by an opaque body
  Lines unsure = 0;          ///< lines of which nothing else is known
  std::vector<RunsIn> glass; ///< of each glass body that was asked for, at the same place
};

class Packets {
public:
  /// Whether the kernels were compiled for an instruction set. The baseline has none, and a compiler that
  /// takes for granted what is wider than a set leaves that out.
  static bool has(core::Simd simd);

  /// For an instruction set that the kernels and the processor have. Solids must outlive this.
  Packets(const Solids& solids, const Balls& balls, core::Simd simd);

  /// If the lines can meet no other bodies than the given ones.
  void meet(const Packet& lines, std::span<const int> bodies, Meetings& meetings) const {
    meet_(*this, lines, bodies, meetings);
  }

  /// The light lies in no body and in no face's plane.
  void shade(const Packet& lines, std::span<const int> opaque, std::span<const int> glass,
             Obstacles& obstacles) const {
    shade_(*this, lines, opaque, glass, obstacles);
  }

  /// SolidTable::OutwardPlane and PlaneSurface as the kernels read them.
  struct Plane {
    Vec3 normal{0};
    double offset = 0;
    double surface = 0;
    double sense = 1; ///< -1: outward is opposite to the surface's own normal
  };

  const SolidTable& table;
  std::vector<Balls::Bound> bounds; ///< one for each body
  std::vector<Plane> planes;        ///< one for each of the table's

  /// Bytes that they hold.
  std::size_t memory() const;

private:
  void (*meet_)(const Packets&, const Packet&, std::span<const int>, Meetings&) = nullptr;
  void (*shade_)(const Packets&, const Packet&, std::span<const int>, std::span<const int>,
                 Obstacles&) = nullptr;
};

} // namespace halftone::geometry
