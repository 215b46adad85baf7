// T. Whitted, "An improved illumination model for shaded display" (1980), with the exact Fresnel terms (the
// scene format, section 3). Where a ray starts in the gap between solids that touch, it takes along what it
// will find there.
//
// Invariant: a reflected branch comes before the refracted one, and both before those of later rays.

#include "branch.h"

#include "signature.h"

#include <halftone/shade/fresnel.h>

#include <algorithm>
#include <utility>

namespace halftone::trace {

namespace {

constexpr std::uint64_t total_reflection = 0x746f7461; // any number that is not a light's signature

struct Branch {
  core::Vec3 direction{0};
  core::Color weight{0};
  bool is_reflected = false;
  int inside = 0;
  bool in_gap = false; ///< it starts in its parent's gap
};

/// inline: with three callers g++ leaves it out of line, at half again the cost.
inline void add(const Ray& parent, const Branch& branch, double cutoff, std::vector<Ray>& next,
                std::span<Sample> samples, Counts& counts) {
  if (core::max_component(branch.weight) < cutoff) {
    ++counts.cut_off;
    return;
  }
  ++(branch.is_reflected ? counts.reflected : counts.refracted);
  ++samples[parent.sample].rays;
  Ray& ray = next.emplace_back(parent);
  ray.direction = branch.direction;
  ray.weight = branch.weight;
  ray.outward = parent.outward != branch.is_reflected;
  ray.in_gap = branch.in_gap;
  ray.at_eye = false;
  ray.inside = branch.inside;
  if (branch.is_reflected) std::swap(ray.gap.ahead, ray.gap.behind);
}

} // namespace

void branch(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays,
            std::span<const Seen> seen, std::span<Local> local, std::vector<Ray>& next,
            std::span<Sample> samples, Counts& counts) {
  const double cutoff = prepared.world.trace.cutoff;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    if (seen[k].kind == SeenKind::nothing) continue;
    const Ray& ray = rays[k];
    const core::Vec3& normal = local[k].normal;

    if (seen[k].kind == SeenKind::opaque) {
      const core::Color& mirror = prepared.material_of(seen[k].met.body).mirror;
      if (mirror == core::black) continue;
      add(ray, {shade::reflect(ray.direction, normal), ray.weight * mirror, true, ray.inside, true}, cutoff,
          next, samples, counts);
      continue;
    }

    const double n1 = prepared.media[seen[k].before].index;
    const double n2 = prepared.media[sets.medium(seen[k].behind)].index;
    // Where nothing is refracted all is reflected, however near to the critical angle.
    const auto bent = shade::refract(ray.direction, normal, n1, n2);
    const double cosine = std::clamp(-glm::dot(ray.direction, normal), 0.0, 1.0);
    const double reflectance = bent ? shade::fresnel_reflectance(cosine, n1, n2) : 1;
    const bool is_entering = seen[k].kind == SeenKind::entering;
    add(ray, {shade::reflect(ray.direction, normal), ray.weight * reflectance, true, ray.inside, is_entering},
        cutoff, next, samples, counts);

    if (!bent) {
      local[k].facts += mixed(total_reflection);
      continue;
    }
    add(ray, {*bent, ray.weight * (1 - reflectance), false, seen[k].behind, !is_entering}, cutoff, next,
        samples, counts);
  }
}

} // namespace halftone::trace
