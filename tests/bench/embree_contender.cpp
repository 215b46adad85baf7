#include "embree_contender.h"

#include "whitted.h"

#include <chrono>
#include <stdexcept>

namespace halftone::bench {

namespace {

/// Embree's own state, which is start-up: one for the process.
RTCDevice device() {
  static const struct Owner {
    RTCDevice device = rtcNewDevice("threads=1,user_threads=1");
    ~Owner() { rtcReleaseDevice(device); }
  } owner;
  if (!owner.device) throw std::runtime_error("Embree does not start");
  return owner.device;
}

template<typename Sample>
Drawn draw_with(const scene::Scene& scene, const Sample& sample) {
  RTCDevice embree = device();
  const auto begin = std::chrono::steady_clock::now();
  const scene::World world = scene::make_world(scene);
  const EmbreeScene embree_scene(embree, world);
  const Whitted tracer(world, embree_scene);
  Drawn drawn;
  const std::vector<core::Color> picture = sample([&](double x, double y) { return tracer.radiance(x, y); });
  drawn.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  drawn.levels = levels_of(picture, scene.image);
  return drawn;
}

struct NamedSettings {
  std::string name;
  Adaptive settings;
};

class EmbreeContender : public Contender {
public:
  explicit EmbreeContender(int threads) : threads_(threads) {}

  std::string name() const override { return "embree"; }
  std::string title() const override { return "Whitted on Embree, adaptive"; }
  std::vector<std::string> settings() const override {
    std::vector<std::string> names;
    for (const NamedSettings& each : all) names.push_back(each.name);
    return names;
  }
  Drawn draw(const Subject& subject, std::size_t setting) override {
    if (setting == 0)
      return draw_with(subject.scene, [&](const Radiance& radiance) {
        return sample_evenly(subject.scene.image, 1, false, threads_, radiance);
      });
    return embree_adaptively(subject.scene, all[setting].settings, threads_);
  }
  Levels converged(const Subject& subject) override {
    constexpr int many = 32;
    return embree_evenly(subject.scene, many, true, threads_);
  }

private:
  inline static const std::vector<NamedSettings> all{
      {"1 sample", {}},
      {"to 2 x 2, contrast 16", {2, 1, 16}},
      {"2 x 2 to 4 x 4, contrast 8", {4, 2, 8}},
      {"2 x 2 to 8 x 8, contrast 8", {8, 2, 8}},
      {"2 x 2 to 8 x 8, contrast 4", {8, 2, 4}},
      {"4 x 4 to 16 x 16, contrast 4", {16, 4, 4}},
      {"4 x 4 to 16 x 16, contrast 2", {16, 4, 2}},
      {"8 x 8 to 32 x 32, contrast 1", {32, 8, 1}},
  };
  int threads_;
};

} // namespace

Levels embree_evenly(const scene::Scene& scene, int n, bool stratified, int threads) {
  return draw_with(scene,
                   [&](const Radiance& radiance) {
                     return sample_evenly(scene.image, n, stratified, threads, radiance);
                   })
      .levels;
}

Drawn embree_adaptively(const scene::Scene& scene, const Adaptive& settings, int threads) {
  return draw_with(scene, [&](const Radiance& radiance) {
    return sample_adaptively(scene.image, settings, threads, radiance);
  });
}

void add_embree(Contenders& contenders, int threads, std::vector<std::string>&) {
  contenders.push_back(std::make_unique<EmbreeContender>(threads));
}

} // namespace halftone::bench
