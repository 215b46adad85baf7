#pragma once
// The ray tree of docs/scene-format.md, section 3, over an EmbreeScene.

#include "embree_scene.h"

namespace halftone::bench {

class Whitted {
public:
  /// Both must outlive this.
  Whitted(const scene::World& world, const EmbreeScene& scene);

  /// Radiance of one ray through continuous image position (x, y), in pixels. Safe to call from several
  /// threads.
  core::Color radiance(double x, double y) const;

private:
  struct PlacedLight {
    scene::Light light;
    InsideSet around;
  };
  struct Ray {
    Line line;
    int start = -1; ///< the body whose surface it leaves
    InsideSet inside;
    core::Color weight{1};
    int depth = 1;
  };
  struct Seen {
    Vec3 position{0};
    Vec3 normal{0}; ///< faces the ray
    int body = -1;
    int face = -1;
  };

  void follow(Ray ray, core::Color& sum) const;
  void spawn(Ray ray, core::Color& sum) const;
  void add_local(const Ray& ray, const Seen& seen, core::Color& sum) const;
  void branch(const Ray& ray, const Seen& seen, const InsideSet& behind, core::Color& sum) const;
  core::Color through_glass(const PlacedLight& light, const Line& line, double distance, int start) const;

  int medium(const InsideSet& inside) const;
  const scene::Material& material_of(int body) const {
    return world_.materials[world_.bodies[body].material];
  }
  double index_in(int body) const { return body < 0 ? 1.0 : material_of(body).glass->ior; }

  const scene::World& world_;
  const EmbreeScene& scene_;
  InsideSet around_eye_;
  std::vector<PlacedLight> lights_;
};

} // namespace halftone::bench
