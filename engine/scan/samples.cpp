#include "samples.h"

#include <halftone/core/mixed.h>

#include <algorithm>
#include <bit>

namespace halftone::scan {

Samples::Samples(const Frame& frame, int top, std::vector<Row>& band)
    : frame_(frame),
      top_(top),
      band_(band) {}

int Samples::add_source(Source source) {
  sources_.push_back(std::move(source));
  return static_cast<int>(sources_.size()) - 1;
}

int Samples::at(int source, const view::ScreenPoint& point) {
  // Ray trees do not depend on which complete list of bodies they are given; on an outline, to rounding.
  const int kind = sources_[source].bodies.empty() ? source + 1 : 0;
  const std::uint64_t key = core::mixed(core::mixed(core::mixed(std::bit_cast<std::uint64_t>(point.x)) ^
                                                    std::bit_cast<std::uint64_t>(point.y)) +
                                        static_cast<std::uint64_t>(kind));
  const int next = static_cast<int>(samples_.size());
  const int known = known_.number_of(key, next);
  if (known == next) samples_.push_back({point, source});
  return known;
}

void Samples::evaluate(Counts& counts) {
  std::vector<trace::EyeRay> rays;
  std::vector<std::size_t> of;
  for (std::size_t i = evaluated_; i < samples_.size(); ++i) {
    ScreenSample& sample = samples_[i];
    const Source& source = sources_[sample.source];
    if (!source.bodies.empty()) {
      rays.push_back({glm::normalize(frame_.screen.direction(sample.at.x, sample.at.y)), source.bodies});
      of.push_back(i);
      continue;
    }
    const std::uint64_t before = counts.rays.shadow;
    const FlatSample flat = shade_flat(frame_, frame_.faces[source.face], source.lights, sample.at.x,
                                       sample.at.y, counts.rays, source.albedo);
    sample.radiance = flat.radiance;
    sample.signature = flat.signature;
    sample.rays = static_cast<int>(counts.rays.shadow - before);
  }
  std::vector<trace::Sample> traced(rays.size());
  frame_.tracer.trace(rays, traced, counts.rays);
  for (std::size_t k = 0; k < of.size(); ++k) {
    samples_[of[k]].radiance = traced[k].radiance;
    samples_[of[k]].signature = traced[k].tree;
    samples_[of[k]].rays = traced[k].rays;
  }
  counts.samples += samples_.size() - evaluated_;
  const int width = frame_.world.camera.width, rows = static_cast<int>(band_.size());
  for (std::size_t i = evaluated_; i < samples_.size(); ++i) {
    const int x = std::clamp(static_cast<int>(samples_[i].at.x), 0, width - 1);
    const int y = std::clamp(static_cast<int>(samples_[i].at.y) - top_, 0, rows - 1);
    PixelNote& note = band_[y].notes[x];
    ++note.samples;
    note.rays += samples_[i].rays;
  }
  evaluated_ = samples_.size();
}

} // namespace halftone::scan
