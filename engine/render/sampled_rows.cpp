#include "row_source.h"

#include <halftone/reference/reference.h>

namespace halftone::render {

namespace {

class SampledRows : public RowSource {
public:
  SampledRows(const scene::World& world, Mode mode, int samples_per_side, int threads)
      : world_(world),
        reference_(world),
        samples_per_side_(samples_per_side),
        sampling_(mode == Mode::reference ? reference::Sampling::stratified : reference::Sampling::centred),
        counts_(threads) {}

  std::vector<DrawnRow> draw(int worker, int y, int, const std::stop_token& stop) override {
    DrawnRow row;
    for (int x = 0; x < world_.camera.width && !stop.stop_requested(); ++x)
      row.radiance.push_back(reference_.pixel(x, y, samples_per_side_, sampling_, counts_[worker]));
    return {std::move(row)};
  }

  void report(Statistics& statistics) const override {
    for (const reference::Counts& count : counts_) {
      statistics.rays.eye += count.eye;
      statistics.rays.reflected += count.reflected;
      statistics.rays.refracted += count.refracted;
      statistics.rays.shadow += count.shadow;
    }
    statistics.samples_per_side = samples_per_side_;
    statistics.samples = statistics.rays.eye;
    statistics.traced_pixels = static_cast<std::uint64_t>(world_.camera.width) * world_.camera.height;
  }

private:
  const scene::World& world_;
  reference::Reference reference_;
  int samples_per_side_;
  reference::Sampling sampling_;
  std::vector<reference::Counts> counts_; ///< of each worker
};

} // namespace

std::unique_ptr<RowSource> sampled_rows(const scene::World& world, Mode mode, int samples_per_side,
                                        int threads) {
  return std::make_unique<SampledRows>(world, mode, samples_per_side, threads);
}

} // namespace halftone::render
