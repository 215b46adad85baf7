#include "counted.h"
#include "row_source.h"
#include "show.h"

#include <halftone/scan/scanner.h>

namespace halftone::render {

namespace {

class ScannedRows : public RowSource {
public:
  ScannedRows(const scene::World& world, const Settings& settings, int threads)
      : frame_(world, core::sagitta, settings.simd),
        lines_(*settings.lines),
        show_(settings.show) {
    for (int worker = 0; worker < threads; ++worker) scanners_.emplace_back(frame_);
  }

  std::vector<DrawnRow> draw(int worker, int y, int, const std::stop_token&) override {
    scan::Row row = scanners_[worker].scan(y, lines_);
    DrawnRow drawn{std::move(row.radiance), {}};
    if (show_) drawn.shown = shown(row.notes, *show_, lines_);
    return {std::move(drawn)};
  }

  void report(Statistics& statistics) const override {
    for (const scan::Scanner& scanner : scanners_) add(scanner.counts, statistics);
    add_frame(frame_, statistics);
    statistics.lines = lines_;
  }

private:
  scan::Frame frame_;
  int lines_;
  std::optional<Show> show_;
  std::vector<scan::Scanner> scanners_; ///< one for each worker
};

} // namespace

std::unique_ptr<RowSource> scanned_rows(const scene::World& world, const Settings& settings, int threads) {
  return std::make_unique<ScannedRows>(world, settings, threads);
}

} // namespace halftone::render
