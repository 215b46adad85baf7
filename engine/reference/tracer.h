#pragma once
// The ray tree of the scene format's section 3, by recursion.

#include "meeting.h"
#include "visibility.h"

#include <halftone/reference/reference.h>
#include <halftone/shade/local.h>

namespace halftone::reference {

/// The solids that contain the eye, and the surface that it lies on, if any.
struct PlacedEye {
  Inside around;
  int surface = -1;
};

class Tracer {
public:
  Tracer(const World& world, const std::vector<PlacedLight>& lights, const PlacedEye& eye, Counts& counts)
      : world_(world),
        lights_(lights),
        eye_(eye),
        counts_(counts) {}

  /// Radiance that arrives at the eye from a unit direction.
  scene::Color eye_ray(const Vec3& direction);

private:
  /// The gap on a surface where solids touch: what a ray in it meets at distance zero, on either side.
  struct Gap {
    Touching ahead;
    Touching behind;
  };

  struct Ray {
    Line line;
    Inside inside;
    scene::Color weight{1};
    int depth = 1;
    std::optional<Gap> gap; ///< set where the ray starts in one
  };

  void follow(Ray ray);
  bool advance(Ray& ray);
  bool meet_in_gap(Ray& ray);
  void refract_or_reflect(const Ray& ray, const Met& boundary, Inside behind, std::optional<Gap> reflected_in,
                          std::optional<Gap> refracted_in);
  void spawn(Ray ray, std::uint64_t& count);
  void add_local_terms(const Ray& ray, const Met& met);

  shade::SurfacePoint surface_point(const Ray& ray, const Met& met) const;
  const scene::Material& material_of(int body) const {
    return world_.materials[world_.bodies[body].material];
  }
  double index_in(int body) const { return body < 0 ? 1.0 : material_of(body).glass->ior; }

  const World& world_;
  const std::vector<PlacedLight>& lights_;
  const PlacedEye& eye_;
  Counts& counts_;
  scene::Color sum_{0};
};

} // namespace halftone::reference
