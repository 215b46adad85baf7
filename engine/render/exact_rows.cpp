#include "counted.h"
#include "row_source.h"
#include "show.h"

#include <halftone/core/small_numbers.h>
#include <halftone/scan/band_scanner.h>

namespace halftone::render {

namespace {

class ExactRows : public RowSource {
public:
  ExactRows(const scene::World& world, const Settings& settings, int threads)
      : frame_(world, settings.quality * core::sagitta_of_quality, settings.simd),
        show_(settings.show),
        scanners_(scan::BandScanner::for_threads(frame_, settings.quality, threads)) {}

  int rows_together() const override { return 32; }

  std::vector<DrawnRow> draw(int worker, int top, int count, const std::stop_token& stop) override {
    std::vector<DrawnRow> drawn;
    for (scan::Row& row : scanners_[worker].scan({top, count}, stop)) {
      drawn.push_back({std::move(row.radiance), {}});
      if (show_) drawn.back().shown = shown(row.notes, *show_, 1);
    }
    return drawn;
  }

  void report(Statistics& statistics) const override {
    for (const scan::BandScanner& scanner : scanners_) add(scanner.counts, statistics);
    add_frame(frame_, statistics);
  }

private:
  scan::Frame frame_;
  std::optional<Show> show_;
  std::vector<scan::BandScanner> scanners_; ///< one for each worker
};

} // namespace

std::unique_ptr<RowSource> exact_rows(const scene::World& world, const Settings& settings, int threads) {
  return std::make_unique<ExactRows>(world, settings, threads);
}

} // namespace halftone::render
