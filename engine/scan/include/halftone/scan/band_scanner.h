#pragma once
// Bands of rows, each pixel the mean over its area: exact where things are flat, sampled by need where rays
// are traced.

#include <halftone/scan/scanner.h>

#include <memory>
#include <stop_token>
#include <vector>

namespace halftone::scan {

/// Rows [top, top + rows).
struct Band {
  int top = 0;
  int rows = 0;
};

/// Remembers the relations and shadows that it has found. One for each thread; bands have the same bits for
/// any.
class BandScanner {
public:
  /// The frame must outlive this. quality: the error aimed at, in 8-bit levels, > 0.
  BandScanner(const Frame& frame, double quality);

  /// One for each thread. They share the shadows that they find.
  static std::vector<BandScanner> for_threads(const Frame& frame, double quality, int threads);

  ~BandScanner();
  BandScanner(BandScanner&&) noexcept;

  /// Where `stop` is asked for it returns soon, with rows that are not finished.
  std::vector<Row> scan(const Band& band, const std::stop_token& stop = {});

  Counts counts; ///< of all bands so far

private:
  struct Impl;
  explicit BandScanner(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

} // namespace halftone::scan
