#pragma once
// Faces drawn by scanlines: where they are seen, cut by the shadows on them and the lines of their pattern.

#include "coverage.h"
#include "face_shadows.h"
#include "integrate.h"
#include "row_shadows.h"

#include <map>
#include <unordered_map>

namespace halftone::scan {

class FlatRows {
public:
  /// Frame and shadows must outlive this. quality: the error aimed at, in 8-bit levels.
  FlatRows(const Frame& frame, FaceShadows& shadows, double quality)
      : frame_(frame),
        shadows_(shadows),
        missed_(quality / 192), // by measuring: highlights of any sharpness within a level (band_test)
        light_sets_(frame.world.lights.size()) {}

  /// What follows is painted into this band.
  void begin(int top, std::vector<Row>& band, Integrator& integrator, Counts& counts);
  void begin_row(int y);

  /// The band is painted when this has been called, but for what the integrator was given.
  void finish();

  void add_pixels(PixelRange pixels, int face);
  void add_piece(int x, const Piece& piece, int face, Pieces& pieces);

  std::uint64_t comparisons = 0; ///< of a row or a piece with a shadow, of a face with a caster, so far

private:
  /// A face in the row that it was last asked for in.
  struct RowOfFace {
    int y = -1;
    RowShadows shadows;
    bool is_steady = false; ///< no piece of a pixel needs more than one sample for the light's sake
  };
  struct Lit {
    Piece piece;
    int lights;
  };
  /// What is painted: a face under a set of lights, with its pattern or with the mean of its colours.
  struct Paint {
    int face = 0;
    int lights = 0;
    bool averaged = false;

    auto operator<=>(const Paint&) const = default;
  };

  /// A sample that is not shaded yet.
  struct Waiting {
    int x = 0, y = 0; ///< its pixel
    view::ScreenPoint at;
    double area = 0;
    core::Color albedo{0};
  };
  struct Painter {
    FlatRun run;
    std::vector<Waiting> waiting; ///< fewer than are shaded side by side
  };

  const RowOfFace& in_row(int face);
  bool is_steady(int face) const;
  void paint(PixelRange pixels, int face, int lights);
  bool paint_run(PixelRange pixels, int face, int lights);
  void paint(int x, const Piece& piece, int face, int lights, Pieces& pieces);
  void paint_cell(int x, const Piece& piece, const Paint& paint, Pieces& pieces);
  void paint_sample(int x, const view::ScreenPoint& at, double area, const Paint& paint);
  std::optional<core::Color> albedo(const Paint& paint) const;
  int source(const Paint& paint);
  Painter& painter_of(const Paint& paint);
  void shade_waiting(Painter& painter);
  bool is_uncertain(int lights) const;
  bool turns(const ScreenFace& face, const Piece& piece, const Pieces& pieces) const;

  const Frame& frame_;
  FaceShadows& shadows_;
  double missed_; ///< of the radiance that is shown as 1, that one sample of a pixel may miss
  LightSets light_sets_;
  std::unordered_map<int, RowOfFace> in_row_; ///< by face
  const RowOfFace* last_ = nullptr;           ///< among them, and its face
  int last_face_ = 0;
  std::map<Paint, int> sources_;      ///< of the band's integrator
  std::map<Paint, Painter> painters_; ///< of the band
  std::vector<Lit> lit_;
  std::vector<int> breaks_;
  std::vector<Piece> cells_;
  Pieces own_pieces_;
  int top_ = 0, y_ = 0;
  std::vector<Row>* band_ = nullptr;
  Integrator* integrator_ = nullptr;
  Counts* counts_ = nullptr;
};

} // namespace halftone::scan
