#pragma once
// Points of one band of rows at which ray trees are traced, or faces shaded whose shadows need rays: each
// point once, whoever asks for it.

#include "flat_shading.h"
#include "number_table.h"

#include <halftone/scan/scanner.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace halftone::scan {

/// What is sampled: ray trees where bodies are given, otherwise the face with the shadow tests that it needs.
struct Source {
  std::vector<int> bodies; ///< that an eye ray may hit first, ascending
  int face = -1;           ///< index into Frame::faces
  std::vector<Lighting> lights;
  std::optional<core::Color> albedo; ///< in place of the face's own
};

struct ScreenSample {
  view::ScreenPoint at;
  int source = 0;
  core::Color radiance{0};
  std::uint64_t signature = 0;
  int rays = 0; ///< cast for it, of all kinds
};

class Samples {
public:
  /// The frame must outlive this. Of rows [top, top + band.size()); the band's notes count samples and rays.
  Samples(const Frame& frame, int top, std::vector<Row>& band);

  /// A number for the source, for the calls below.
  int add_source(Source source);
  const Source& source(int number) const { return sources_[number]; }

  /// The sample of a source at a point, which is new unless the same was asked for before. It is known after
  /// evaluate().
  int at(int source, const view::ScreenPoint& point);

  /// All that are new, as one batch.
  void evaluate(Counts& counts);

  const ScreenSample& operator[](int sample) const { return samples_[sample]; }

private:
  const Frame& frame_;
  int top_;
  std::vector<Row>& band_;
  std::vector<Source> sources_;
  std::vector<ScreenSample> samples_;
  std::size_t evaluated_ = 0;
  NumberTable known_; ///< by the bits of the point and the kind of source, mixed
};

} // namespace halftone::scan
