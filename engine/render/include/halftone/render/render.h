#pragma once
// The pipeline: from a scene to rows of pixels.

#include <halftone/core/simd.h>
#include <halftone/scene/scene.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

namespace halftone::render {

enum class Mode { local, scanline, full, reference };

/// What the engine decided, painted instead of the picture (docs/show.md has the colours).
enum class Show {
  signatures, ///< what is seen: one colour for each combination of things, lights and cells; not with lines
  intervals,  ///< visible intervals of a pixel's virtual scanlines, and which were ray traced
  samples,    ///< points that were shaded
  cost,       ///< rays that were cast
};

struct Settings {
  Mode mode = Mode::local;
  std::optional<int> samples; ///< full and reference: per pixel side, >= 1; by default 4 and 16
  int threads = 0;            ///< 0: one for each processor. Rows have the same bits for any number.
  std::optional<int>
      lines; ///< local and scanline: the paper's method with so many virtual scanlines a row, >= 1
  double quality = 0.25;    ///< local and scanline without lines: the error aimed at, in 8-bit levels, > 0
  std::optional<Show> show; ///< local and scanline
  core::Simd simd = core::widest_simd(); ///< the processor must have it. Rows have the same bits with any.
};

/// A finished row, valid during the call that delivers it.
struct Row {
  int y = 0;                             ///< from the top
  std::span<const core::Color> radiance; ///< width pixels, linear, before exposure
  std::span<const std::uint8_t>
      rgb; ///< 3 * width bytes after exposure, transfer and rounding, or what is shown
};

struct Rays {
  std::uint64_t eye = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;
};

/// What the scene did not need.
struct Skipped {
  std::uint64_t lights = 0;   ///< that reach nothing
  std::uint64_t objects = 0;  ///< out of sight, which shadow nothing and are in no ray's way
  std::uint64_t faces = 0;    ///< that look at the eye, but lie wholly behind one of the largest
  std::uint64_t casters = 0;  ///< pairs of a light and a body that shadows nothing which is not dark anyway
  std::uint64_t branches = 0; ///< of ray trees, reflected and refracted, below the scene's cutoff
  std::uint64_t samples = 0;  ///< pixels in which at most one was taken
};

struct Statistics {
  Mode mode = Mode::local;
  int threads = 1;
  core::Simd simd{};                ///< that kernels could use; full and reference are scalar code
  int samples_per_side = 0;         ///< 0 where the mode has no grid of samples
  int lines = 0;                    ///< virtual scanlines a row; 0 where the mode has none
  double prepare_seconds = 0;       ///< scene to world, before the first row
  double render_seconds = 0;        ///< scene prepared to last row, monotonic clock
  std::uint64_t prepared_bytes = 0; ///< memory of the scene as prepared; not what rows remember while drawn
  std::uint64_t objects = 0;        ///< of the scene
  Rays rays;
  std::uint64_t virtual_lines = 0;
  std::uint64_t intervals = 0;
  std::uint64_t samples = 0;
  std::uint64_t comparisons = 0;   ///< to find what matters: rays with bodies; without lines rows, pixels and
                                   ///< faces with shapes and shadows, too; none in full and reference
  std::uint64_t traced_pixels = 0; ///< pixels in which at least one eye ray was cast
  Skipped skipped;
};

/// Draws the scene and hands each finished row to sink, from top to bottom, on the calling thread. What sink
/// throws ends the render and reaches the caller. Where `stop` is asked for, from any thread, the render ends
/// early, with no further row: in some hundredths of a second, or as soon as a scene is prepared.
Statistics render(const scene::Scene& scene, const Settings& settings,
                  const std::function<void(const Row&)>& sink, std::stop_token stop = {});

std::string_view name(Mode mode);
std::string_view name(Show show);

} // namespace halftone::render
