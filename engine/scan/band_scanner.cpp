#include <halftone/scan/band_scanner.h>

#include "coverage.h"
#include "flat_rows.h"
#include "integrate.h"

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

/// Shares of the quality, found by measuring (docs/method.md). From 1 on a pixel is not searched for what its
/// corners do not show.
Tolerance tolerance_for(double quality) {
  const bool is_coarse = quality >= 1;
  int scouts = 1;
  while (scouts < 32 && scouts * quality < 1) scouts *= 2;
  Tolerance tolerance;
  tolerance.smooth = 40 * quality;
  tolerance.curved = 4 * quality;
  tolerance.edge = is_coarse ? 12 * std::sqrt(quality * std::sqrt(quality)) : 8 * std::sqrt(quality);
  tolerance.hidden = is_coarse ? 0.25 : 0.5;
  tolerance.place = (is_coarse ? 2 : 3) * quality;
  tolerance.piece = quality / 16;
  tolerance.unseen = std::clamp(quality, 0.25, 1.0);
  tolerance.plain = is_coarse ? 0.3 : 1.0 / 16;
  tolerance.scouts = scouts;
  tolerance.looks_before_dividing = !is_coarse;
  tolerance.probes_sides = quality < 0.5;
  return tolerance;
}

} // namespace

struct BandScanner::Impl {
  Impl(const Frame& drawn, double aim, std::shared_ptr<FaceShadows> shared)
      : frame(drawn),
        tolerance(tolerance_for(aim)),
        order(drawn.world, drawn.hulls),
        shadows(std::move(shared)),
        coverage(drawn, order, sets),
        flat(drawn, *shadows, aim) {}

  const Frame& frame;
  Tolerance tolerance;
  order::Order order;
  std::shared_ptr<FaceShadows> shadows;
  BodySets sets;
  Coverage coverage;
  FlatRows flat;
};

namespace {

/// Hands what is covered to those who paint it.
class Painter : public CoverageSink {
public:
  Painter(const Frame& frame, BodySets& sets, FlatRows& flat, Integrator& integrator, std::vector<Row>& band,
          int top, Counts& counts)
      : frame_(frame),
        sets_(sets),
        flat_(flat),
        integrator_(integrator),
        band_(band),
        top_(top),
        counts_(counts) {}

  void begin_row(int y) {
    y_ = y;
    flat_.begin_row(y);
  }

  void add_pixels(PixelRange pixels, const InFront& seen) override {
    ++counts_.intervals;
    for (int x = pixels.begin; x < pixels.end; ++x) {
      ++row().notes[x].intervals;
      if (seen.traced != 0) integrator_.add_pixel(x, y_, traced_source(seen));
      if (seen.traced == 0 && seen.face < 0) row().radiance[x] += frame_.world.background;
    }
    if (seen.traced == 0 && seen.face >= 0) flat_.add_pixels(pixels, seen.face);
  }

  void add_parts(int x, std::span<const Part> parts, Pieces& pieces) override {
    const auto is_traced = [](const Part& part) { return part.seen.traced != 0; };
    if (std::all_of(parts.begin(), parts.end(), is_traced)) {
      counts_.intervals += parts.size();
      row().notes[x].intervals += static_cast<int>(parts.size());
      traced_.clear();
      for (const Part& part : parts)
        traced_.push_back(integrator_.screen_piece(pieces, part.piece, traced_source(part.seen)));
      integrator_.add_cut_pixel(x, y_, traced_, source_of_any(parts));
      return;
    }
    for (const Part& part : parts) add_part(x, part, pieces);
  }

private:
  void add_part(int x, const Part& part, Pieces& pieces) {
    const auto& [piece, seen] = part;
    ++counts_.intervals;
    ++row().notes[x].intervals;
    if (seen.traced != 0) {
      integrator_.add_piece(x, y_, integrator_.screen_piece(pieces, piece, traced_source(seen)));
    } else if (seen.face < 0) {
      row().radiance[x] += pieces.area(piece) * frame_.world.background;
    } else {
      flat_.add_piece(x, piece, seen.face, pieces);
    }
  }

  Row& row() { return band_[y_ - top_]; }

  /// The bodies that an eye ray through the part may hit first.
  int set_of(const InFront& seen) {
    return seen.face < 0 ? seen.traced : sets_.with(seen.traced, frame_.faces[seen.face].body);
  }

  int traced_source(const InFront& seen) { return source_of(set_of(seen)); }

  int source_of_any(std::span<const Part> parts) {
    int all = 0;
    for (const Part& part : parts) {
      const int set = set_of(part.seen);
      for (std::size_t k = 0; k < sets_.bodies(set).size(); ++k) all = sets_.with(all, sets_.bodies(set)[k]);
    }
    return source_of(all);
  }

  std::vector<int> bodies_of(int set) const {
    const auto bodies = sets_.bodies(set);
    return {bodies.begin(), bodies.end()};
  }

  int source_of(int set) {
    const auto [known, is_new] = sources_.try_emplace(set, 0);
    if (is_new) known->second = integrator_.add_source({bodies_of(set), -1, {}, {}});
    return known->second;
  }

  const Frame& frame_;
  BodySets& sets_;
  FlatRows& flat_;
  Integrator& integrator_;
  std::vector<Row>& band_;
  int top_;
  Counts& counts_;
  int y_ = 0;
  std::vector<ScreenPiece> traced_;
  std::map<int, int> sources_; ///< of the integrator, by set of bodies
};

} // namespace

BandScanner::BandScanner(const Frame& frame, double quality)
    : BandScanner(std::make_unique<Impl>(frame, quality, std::make_shared<FaceShadows>(frame))) {}
BandScanner::BandScanner(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
BandScanner::~BandScanner() = default;
BandScanner::BandScanner(BandScanner&&) noexcept = default;

std::vector<BandScanner> BandScanner::for_threads(const Frame& frame, double quality, int threads) {
  const auto shadows = std::make_shared<FaceShadows>(frame);
  std::vector<BandScanner> scanners;
  for (int thread = 0; thread < threads; ++thread)
    scanners.push_back(BandScanner(std::make_unique<Impl>(frame, quality, shadows)));
  return scanners;
}

std::vector<Row> BandScanner::scan(const Band& band, const std::stop_token& stop) {
  const std::size_t width = impl_->frame.world.camera.width;
  std::vector<Row> rows(band.rows,
                        Row{std::vector<core::Color>(width, core::black), std::vector<PixelNote>(width)});
  Integrator integrator(impl_->frame, band.top, impl_->tolerance, rows);
  impl_->flat.begin(band.top, rows, integrator, counts);
  Painter painter(impl_->frame, impl_->sets, impl_->flat, integrator, rows, band.top, counts);
  for (int y = band.top; y < band.top + band.rows && !stop.stop_requested(); ++y) {
    painter.begin_row(y);
    impl_->coverage.cover(y, painter);
  }
  if (!stop.stop_requested()) {
    impl_->flat.finish();
    integrator.finish(counts, stop);
  }
  counts.comparisons = impl_->coverage.comparisons + impl_->flat.comparisons;
  for (const Row& row : rows)
    for (const PixelNote& note : row.notes) {
      counts.traced_pixels += note.traced ? 1 : 0;
      counts.plain_pixels += note.samples <= 1 ? 1 : 0;
    }
  return rows;
}

} // namespace halftone::scan
