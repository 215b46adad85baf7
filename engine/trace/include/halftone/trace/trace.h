#pragma once
// Local ray tracing in batches: whole ray trees for many eye rays at once.

#include <halftone/core/simd.h>
#include <halftone/scene/world.h>

#include <cstdint>
#include <memory>
#include <span>

namespace halftone::trace {

/// An eye ray whose first hit the scan has narrowed down.
struct EyeRay {
  core::Vec3 direction{0};         ///< unit length
  std::span<const int> candidates; ///< bodies that the first hit can be on, complete up to rounding on
                                   ///< outlines, ascending; valid during the call. Bodies that contain the
                                   ///< eye are among them.
};

/// What an eye ray brings.
struct Sample {
  core::Color radiance{0};
  std::uint64_t first = 0; ///< signature of the first hit: body, face, cell of the pattern, lights that reach
                           ///< it and through which bodies; 0 where nothing is hit
  std::uint64_t tree = 0;  ///< the same over the whole tree, as a sum that does not depend on order
  int rays = 0;            ///< cast for it: eye, reflected, refracted and shadow rays
};

/// A point of a surface that light may reach.
struct LitPoint {
  core::Vec3 position{0};
  int surface = -1; ///< index into World::surfaces that the point lies on
  int body = -1;    ///< whose surface it is
};

/// How much of a light reaches a point.
struct Visible {
  core::Color value{1};        ///< V of the scene format's section 4, per channel
  std::uint64_t signature = 0; ///< blocked, or the glass faces that the light crosses
};

struct Counts {
  std::uint64_t eye = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;
  std::uint64_t comparisons = 0; ///< of a ray with a body
  std::uint64_t cut_off = 0;     ///< reflected and refracted rays that were not cast, below the cutoff
};

/// How bodies are found that a ray may meet. Samples have the same bits either way.
enum class Search {
  by_number, ///< the faster one, as far as the number of bodies tells
  all,       ///< each body is asked
  hierarchy,
};

class Tracer {
public:
  /// The world must outlive this. The processor must have the instruction set; samples have the same bits
  /// with any.
  explicit Tracer(const scene::World& world, Search search = Search::by_number,
                  core::Simd simd = core::widest_simd());
  ~Tracer();

  /// samples.size() == rays.size(). Safe to call from several threads; the samples of a ray do not depend on
  /// what else is in the batch.
  void trace(std::span<const EyeRay> rays, std::span<Sample> samples, Counts& counts) const;

  /// V for one of World::lights, if no body but the given ones (ascending) can stand in its way. One shadow
  /// ray.
  Visible visibility(const LitPoint& point, int light, std::span<const int> casters, Counts& counts) const;

  /// Bytes that were prepared for all rays.
  std::size_t memory() const;

private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

} // namespace halftone::trace
