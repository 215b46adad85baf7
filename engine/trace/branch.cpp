// T. Whitted, "An improved illumination model for shaded display" (1980), with the exact Fresnel terms (the
// scene format, section 3). Where a ray starts in the gap between solids that touch, it takes along what it
// will find there.
//
// Invariant: a reflected branch comes before the refracted one, and both before those of later rays.

#include "branch.h"

#include "signature.h"

#include <halftone/shade/fresnel.h>

#include <algorithm>

namespace halftone::trace {

namespace {

constexpr std::uint64_t total_reflection = 0x746f7461; // any number that is not a light's signature

/// What the branches of one ray have in common.
struct Parent {
  const Rays& rays;
  std::size_t ray;
  const scene::Trace& limits;
};

struct Branch {
  core::Vec3 direction{0};
  core::Color weight{0};
  bool is_reflected = false;
  int inside = 0;
  const Gap* gap = nullptr; ///< where it starts in one
};

void add(const Parent& parent, const Branch& branch, Rays& next, std::span<Sample> samples, Counts& counts) {
  if (core::max_component(branch.weight) < parent.limits.cutoff) {
    ++counts.cut_off;
    return;
  }
  ++(branch.is_reflected ? counts.reflected : counts.refracted);
  const std::size_t i = next.add();
  const std::size_t from = parent.ray;
  next.set_origin(i, parent.rays.origin(from));
  next.set_direction(i, branch.direction);
  next.set_weight(i, branch.weight);
  next.surface[i] = parent.rays.surface[from];
  next.outward[i] = (parent.rays.outward[from] != 0) != branch.is_reflected;
  next.inside[i] = branch.inside;
  next.in_gap[i] = branch.gap != nullptr;
  if (branch.gap) next.gap[i] = next.adopted(*branch.gap, parent.rays);
  next.sample[i] = parent.rays.sample[from];
  ++samples[next.sample[i]].rays;
}

} // namespace

void branch(const Prepared& prepared, const InsideSets& sets, const Rays& rays, Slice slice, const Seen& seen,
            Local& local, Rays& next, std::span<Sample> samples, Counts& counts) {
  for (std::size_t k = 0; k < slice.size(); ++k) {
    if (seen.kind[k] == SeenKind::nothing) continue;
    const std::size_t ray = slice.begin + k;
    const Parent parent{rays, ray, prepared.world.trace};
    const core::Color weight = rays.weight(ray);
    const core::Vec3 direction = rays.direction(ray);
    const core::Vec3& normal = local.points[k].normal;
    const Gap back = turned(rays.gap[ray]);

    if (seen.kind[k] == SeenKind::opaque) {
      const core::Color& mirror = prepared.material_of(seen.met[k].body).mirror;
      if (mirror == core::black) continue;
      const Branch reflected{shade::reflect(direction, normal), weight * mirror, true, rays.inside[ray],
                             &back};
      add(parent, reflected, next, samples, counts);
      continue;
    }

    const double n1 = prepared.media[seen.before[k]].index;
    const double n2 = prepared.media[sets.medium(seen.behind[k])].index;
    // Where nothing is refracted all is reflected, however near to the critical angle.
    const auto bent = shade::refract(direction, normal, n1, n2);
    const double cosine = std::clamp(-glm::dot(direction, normal), 0.0, 1.0);
    const double reflectance = bent ? shade::fresnel_reflectance(cosine, n1, n2) : 1;
    const bool is_entering = seen.kind[k] == SeenKind::entering;
    const Branch reflected{shade::reflect(direction, normal), weight * reflectance, true, rays.inside[ray],
                           is_entering ? &back : nullptr};
    add(parent, reflected, next, samples, counts);

    if (!bent) {
      local.facts[k] += mixed(total_reflection);
      continue;
    }
    const Branch refracted{*bent, weight * (1 - reflectance), false, seen.behind[k],
                           is_entering ? nullptr : &rays.gap[ray]};
    add(parent, refracted, next, samples, counts);
  }
}

} // namespace halftone::trace
