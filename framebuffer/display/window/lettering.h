#pragma once
// Words on the window.

#include <SDL_render.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::display {

struct TextureEnd {
  void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
};
using Texture = std::unique_ptr<SDL_Texture, TextureEnd>;

/// Lines broken at blanks, and where there is none anywhere, so that none is longer than so many characters.
std::vector<std::string> wrapped(const std::vector<std::string>& lines, std::size_t most);

class Lettering {
public:
  /// Throws DisplayError.
  explicit Lettering(SDL_Renderer* renderer);

  /// Characters of a line on so many pixels of the renderer's output, and the pixels that so many lines take,
  /// where a dot of a letter takes so many pixels.
  static std::size_t fitting(int width, int dot);
  static int height_of(std::size_t lines, int dot);

  /// On a dark ground with a margin around it; x and y are its top left.
  void draw(const std::vector<std::string>& lines, int x, int y, int dot) const;

private:
  SDL_Renderer* renderer_;
  Texture glyphs_;
};

} // namespace halftone::display
