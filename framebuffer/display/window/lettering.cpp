#include "lettering.h"

#include "failure.h"
#include "font.h"

#include <SDL_pixels.h>

#include <algorithm>
#include <cstdint>

namespace halftone::display {

namespace {

constexpr int cell_width = glyph_width + 1;
constexpr int cell_height = glyph_height + 1;
constexpr int margin = 3; // dots

constexpr int sheet_width = cell_width * (glyph_count + 1); // the last one for what has no glyph

std::vector<std::uint32_t> sheet() {
  constexpr std::uint32_t white = 0xFFFFFFFF, clear = 0x00FFFFFF;
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(sheet_width) * glyph_height, clear);
  for (int glyph = 0; glyph <= glyph_count; ++glyph) {
    const Glyph& rows = glyph_of(static_cast<char>(first_glyph + glyph));
    for (int y = 0; y < glyph_height; ++y)
      for (int x = 0; x < glyph_width; ++x)
        if ((rows[static_cast<std::size_t>(y)] >> (glyph_width - 1 - x) & 1) != 0)
          pixels[static_cast<std::size_t>(y * sheet_width + glyph * cell_width + x)] = white;
  }
  return pixels;
}

} // namespace

std::vector<std::string> wrapped(const std::vector<std::string>& lines, std::size_t most) {
  std::vector<std::string> parts;
  for (std::string_view rest : lines) {
    while (rest.size() > most) {
      const std::size_t blank = rest.rfind(' ', most);
      const std::size_t cut = blank == std::string_view::npos || blank == 0 ? most : blank;
      parts.emplace_back(rest.substr(0, cut));
      rest.remove_prefix(std::min(rest.size(), cut == blank ? cut + 1 : cut));
    }
    parts.emplace_back(rest);
  }
  return parts;
}

Lettering::Lettering(SDL_Renderer* renderer)
    : renderer_(renderer),
      glyphs_(SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STATIC, sheet_width,
                                glyph_height)) {
  require(glyphs_ != nullptr);
  const std::vector<std::uint32_t> pixels = sheet();
  require(SDL_UpdateTexture(glyphs_.get(), nullptr, pixels.data(), sheet_width * 4) == 0);
  SDL_SetTextureBlendMode(glyphs_.get(), SDL_BLENDMODE_BLEND);
}

std::size_t Lettering::fitting(int width, int dot) {
  return static_cast<std::size_t>(std::max(1, (width / dot + 1 - 2 * margin) / cell_width));
}

int Lettering::height_of(std::size_t lines, int dot) {
  return (static_cast<int>(lines) * cell_height - 1 + 2 * margin) * dot;
}

void Lettering::draw(const std::vector<std::string>& lines, int x, int y, int dot) const {
  std::size_t longest = 0;
  for (const std::string& line : lines) longest = std::max(longest, line.size());
  const int width = (static_cast<int>(longest) * cell_width - 1 + 2 * margin) * dot;
  const SDL_Rect ground{x, y, width, height_of(lines.size(), dot)};
  SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
  SDL_SetRenderDrawColor(renderer_, 0, 0, 0, 210);
  SDL_RenderFillRect(renderer_, &ground);
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t column = 0; column < lines[row].size(); ++column) {
      const int code = lines[row][column] - first_glyph;
      const int glyph = code >= 0 && code < glyph_count ? code : glyph_count;
      const SDL_Rect from{glyph * cell_width, 0, glyph_width, glyph_height};
      const SDL_Rect to{x + (margin + static_cast<int>(column) * cell_width) * dot,
                        y + (margin + static_cast<int>(row) * cell_height) * dot, glyph_width * dot,
                        glyph_height * dot};
      SDL_RenderCopy(renderer_, glyphs_.get(), &from, &to);
    }
  }
}

} // namespace halftone::display
