#pragma once
// Where rows come from: one for each way to draw.

#include <halftone/render/render.h>
#include <halftone/scene/world.h>

#include <memory>
#include <stop_token>
#include <vector>

namespace halftone::render {

struct DrawnRow {
  std::vector<core::Color> radiance;
  std::vector<std::uint8_t>
      shown; ///< 3 bytes a pixel where something else than the picture is asked for, or empty
};

class RowSource {
public:
  virtual ~RowSource() = default;

  /// Rows that are drawn together, at least 1.
  virtual int rows_together() const { return 1; }

  /// Draws rows [top, top + count), a multiple of rows_together() from the top of the picture. worker is in
  /// [0, threads); calls with different workers may run at once. Where `stop` is asked for it returns soon,
  /// with rows that are not finished.
  virtual std::vector<DrawnRow> draw(int worker, int top, int count, const std::stop_token& stop) = 0;

  /// Adds what was counted in all rows so far.
  virtual void report(Statistics& statistics) const = 0;
};

/// Modes full and reference. The world must outlive the source, as below.
std::unique_ptr<RowSource> sampled_rows(const scene::World& world, Mode mode, int samples_per_side,
                                        int threads);

/// Modes local and scanline: the exact rows, with an aim in 8-bit levels.
std::unique_ptr<RowSource> exact_rows(const scene::World& world, const Settings& settings, int threads);

/// Modes local and scanline with a fixed number of virtual scanlines: the paper's method.
std::unique_ptr<RowSource> scanned_rows(const scene::World& world, const Settings& settings, int threads);

} // namespace halftone::render
