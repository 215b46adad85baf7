#include "show.h"

#include <halftone/core/mixed.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace halftone::render {

namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// One colour for each doubling: 0, 1, 2 to 3, 4 to 7, ..., 4096 and more. From black through blue, red and
/// yellow to white, each brighter than the one before.
constexpr std::array<Rgb, 14> ramp{{{0, 0, 0},
                                    {20, 18, 74},
                                    {38, 30, 120},
                                    {66, 40, 150},
                                    {104, 46, 156},
                                    {140, 52, 146},
                                    {174, 60, 122},
                                    {204, 76, 92},
                                    {228, 98, 62},
                                    {242, 128, 36},
                                    {250, 160, 30},
                                    {254, 196, 60},
                                    {255, 228, 130},
                                    {255, 255, 220}}};

Rgb doubling(int count) {
  const auto width = std::bit_width(static_cast<unsigned>(std::max(count, 0)));
  return ramp[std::min<std::size_t>(width, ramp.size() - 1)];
}

/// Blue: drawn by the scan alone; orange: ray traced. Brighter for each interval more than one a virtual
/// scanline.
Rgb intervals_of(const scan::PixelNote& note, int lines) {
  const int more = std::clamp((note.intervals - lines) * 4 / lines, 0, 4);
  if (note.traced)
    return {static_cast<std::uint8_t>(150 + 26 * more), static_cast<std::uint8_t>(80 + 35 * more), 20};
  return {static_cast<std::uint8_t>(16 + 35 * more), static_cast<std::uint8_t>(40 + 40 * more),
          static_cast<std::uint8_t>(90 + 41 * more)};
}

/// Bright enough to be told from black, which is the background's.
Rgb color_of(std::uint64_t signature) {
  if (signature == 0) return {0, 0, 0};
  const std::uint64_t bits = core::mixed(signature);
  return {static_cast<std::uint8_t>(64 + bits % 192), static_cast<std::uint8_t>(64 + (bits >> 16) % 192),
          static_cast<std::uint8_t>(64 + (bits >> 32) % 192)};
}

} // namespace

std::vector<std::uint8_t> shown(const std::vector<scan::PixelNote>& notes, Show show, int lines) {
  std::vector<std::uint8_t> rgb;
  for (const scan::PixelNote& note : notes) {
    const Rgb color = show == Show::signatures  ? color_of(note.signature)
                      : show == Show::intervals ? intervals_of(note, lines)
                      : show == Show::samples   ? doubling(note.samples)
                                                : doubling(note.rays);
    rgb.insert(rgb.end(), color.begin(), color.end());
  }
  return rgb;
}

} // namespace halftone::render
