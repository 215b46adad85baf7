#pragma once
// Where shadows may fall on a flat face, as convex regions of the screen.

#include <halftone/core/small_numbers.h>
#include <halftone/geometry/bounding.h>
#include <halftone/view/screen.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace halftone::shadow {

using core::Vec3;

/// The shadow of one body from one light on one face.
struct Region {
  int caster = 0; ///< index into World::bodies
  /// The whole region is dark: the caster is flat and opaque. Otherwise the shadow of its true shape lies
  /// within, or light passes through it.
  bool dark = false;
  /// The light is inside the caster's hull or in the plane of one of its faces, so the shadow may be
  /// anywhere: the outline is the screen.
  bool anywhere = false;
  view::ScreenPolygon outline;
  /// Of a round caster, the shadow of its true shape, circles being replaced by inscribed polygons
  /// that leave less area than a strip of a sagitta along the outline; where it is known. Of an opaque one
  /// all of it is dark.
  std::optional<view::ScreenPolygon> round;
};

/// Regions are found when they are first asked for, and remembered. Not for use by several threads at once:
/// each has a copy, which is cheap as long as nothing was asked for.
class Shadows {
public:
  /// All must outlive this. hulls: one for each body. casters: for each light the bodies to be asked.
  /// sagitta: between a circle's shadow and the chords that replace it, in pixels.
  Shadows(const scene::World& world, const view::Screen& screen, const std::vector<geometry::Hull>& hulls,
          const std::vector<std::vector<int>>& casters, double sagitta = core::sagitta);

  /// Every body that can keep the light from the face has its region in the list, in ascending order of
  /// bodies.
  const std::vector<Region>& on(int body, int face, int light);

  /// Those that are not apart from the part of the face that is seen, found again at each call. Safe to call
  /// from several threads. Adds to the number of casters that the face was compared with.
  std::vector<Region> find(int body, int face, int light, const view::ScreenPolygon& seen,
                           std::uint64_t& compared) const;

  /// Bytes that copies share.
  std::size_t memory() const;

  std::uint64_t comparisons = 0; ///< of a face with a caster, by on() so far

private:
  struct Receiver;
  struct Cones;
  using Loops = std::function<std::vector<std::vector<int>>()>;
  std::optional<view::ScreenPolygon> thrown(const Receiver& receiver, const std::vector<Vec3>& vertices,
                                            const Loops& loops) const;
  std::optional<view::ScreenPolygon> thrown_by_round(const Receiver& receiver, const scene::Body& body,
                                                     const view::ScreenPolygon& around) const;

  const scene::World& world_;
  const view::Screen& screen_;
  const std::vector<geometry::Hull>& hulls_;
  const std::vector<std::vector<int>>& casters_;
  double sagitta_;
  std::unordered_map<std::uint64_t, std::vector<Region>> known_;
  std::shared_ptr<const std::vector<Cones>> cones_; ///< for each light, those of its casters
};

} // namespace halftone::shadow
