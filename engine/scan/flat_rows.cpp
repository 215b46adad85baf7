// Shadows cut what is seen like edges do: on a flat receiver the shadow of a flat caster is a polygon on the
// screen, that of a round one is bounded by conics, replaced by chords that leave less than 2^-10 pixel. What
// lies between is constant in what it sees, and has one sample at its centroid.

#include "flat_rows.h"

#include "highlight.h"
#include "pattern.h"

#include <halftone/core/mixed.h>

#include <algorithm>

namespace halftone::scan {

namespace {

/// More lines of a pattern than this in a pixel are not cut, but averaged.
constexpr double most_lines = 64;

/// A face, the lights that are dark on it, and what its shading says of itself.
std::uint64_t signature_of(int face, const std::vector<Lighting>& lights, std::uint64_t shading) {
  std::uint64_t signature = core::mixed(static_cast<std::uint64_t>(face) + 1) + shading;
  for (const Lighting& light : lights) signature = core::mixed(signature + (light.dark ? 1 : 2));
  return signature;
}

} // namespace

void FlatRows::begin(int top, std::vector<Row>& band, Integrator& integrator, Counts& counts) {
  top_ = top;
  band_ = &band;
  integrator_ = &integrator;
  counts_ = &counts;
  sources_.clear();
}

void FlatRows::begin_row(int y) {
  y_ = y;
  in_row_.clear();
}

const std::vector<FlatRows::RowShadow>& FlatRows::shadows_in_row(int face) {
  const auto [known, is_new] = in_row_.try_emplace(face);
  if (!is_new) return known->second;
  const auto [all, are_new] = of_face_.try_emplace(face);
  if (are_new) all->second = shadows_of(frame_, shadows_, frame_.faces[face]);
  for (const FaceShadow& shadow : all->second) {
    if (!(shadow.outline.top < y_ + 1 && shadow.outline.bottom > y_)) continue;
    RowOutline row = shadow.outline.in_row(y_);
    if (!row.touched.is_empty()) known->second.push_back({&shadow, std::move(row)});
  }
  // Dark ones first: where a light is dark, nothing else matters to it.
  std::stable_partition(known->second.begin(), known->second.end(),
                        [](const RowShadow& shadow) { return shadow.shadow->dark; });
  return known->second;
}

bool FlatRows::is_uncertain(int lights) const {
  const auto& list = light_sets_.lights(lights);
  return std::any_of(list.begin(), list.end(), [](const Lighting& l) { return !l.casters.empty(); });
}

int FlatRows::source(int face, int lights) {
  const auto [known, is_new] = sources_.try_emplace({face, lights}, 0);
  if (is_new) known->second = integrator_->add_source({{}, face, light_sets_.lights(lights)});
  return known->second;
}

void FlatRows::add_pixels(PixelRange pixels, int face) {
  const std::vector<RowShadow>& shadows = shadows_in_row(face);
  std::vector<int> breaks{pixels.begin, pixels.end};
  for (const RowShadow& shadow : shadows)
    for (const int x :
         {shadow.row.touched.begin, shadow.row.full.begin, shadow.row.full.end, shadow.row.touched.end})
      if (x > pixels.begin && x < pixels.end) breaks.push_back(x);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const PixelRange run{breaks[i], breaks[i + 1]};
    int lights = 0;
    bool partial = false;
    for (const RowShadow& shadow : shadows) {
      if (!shadow.row.touched.contains(run.begin)) continue;
      if (light_sets_.lights(lights)[shadow.shadow->light].dark) continue;
      if (shadow.row.full.contains(run.begin))
        lights = light_sets_.with(lights, *shadow.shadow);
      else
        partial = true;
    }
    if (!partial) {
      paint(run, face, lights);
      continue;
    }
    for (int x = run.begin; x < run.end; ++x) add_piece(x, own_pieces_.whole(x, y_), face, own_pieces_);
  }
}

void FlatRows::add_piece(int x, const Piece& piece, int face, Pieces& pieces) {
  lit_.clear();
  lit_.push_back({piece, 0});
  for (const RowShadow& shadow : shadows_in_row(face)) {
    if (!shadow.row.touched.contains(x)) continue;
    const std::size_t count = lit_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Lit part = lit_[i];
      const int shaded = light_sets_.with(part.lights, *shadow.shadow);
      if (shaded == part.lights) continue;
      const std::size_t before = lit_.size();
      Piece inside = part.piece;
      for (const RowEdge& edge : shadow.row.edges) {
        if (!edge.pixels.contains(x)) continue;
        const Sides sides = pieces.cut(inside, edge.edge);
        inside = sides.inside;
        if (inside.count == 0) break;
        if (sides.outside.count > 0) lit_.push_back({sides.outside, part.lights});
      }
      if (inside.count == 0)
        lit_.resize(before);
      else
        lit_[i] = {inside, shaded};
    }
  }
  for (std::size_t i = 0; i < lit_.size(); ++i) paint(x, lit_[i].piece, face, lit_[i].lights, pieces);
}

/// Whether a stand-in's round normal turns away from the eye within the piece.
bool FlatRows::turns(const ScreenFace& face, int, const Piece& piece, const Pieces& pieces) const {
  if (!frame_.world.bodies[face.body].faces[face.face].rounded) return false;
  int turned = 0;
  for (int k = 0; k < piece.count; ++k) {
    const view::ScreenPoint p = pieces.corner(piece, k);
    turned += is_turned(frame_, face, p.x, p.y) ? 1 : 0;
  }
  return turned != 0 && turned != piece.count;
}

void FlatRows::paint(PixelRange pixels, int face, int lights) {
  const ScreenFace& drawn = frame_.faces[face];
  const scene::Body& body = frame_.world.bodies[drawn.body];
  const bool plain = !frame_.world.materials[body.material].checker && !body.faces[drawn.face].rounded;
  const bool uncertain = is_uncertain(lights);
  for (int x = pixels.begin; x < pixels.end; ++x) {
    if (!plain)
      paint(x, own_pieces_.whole(x, y_), face, lights, own_pieces_);
    else if (uncertain)
      integrator_->add_pixel(x, y_, source(face, lights));
    else
      paint_cell(x, own_pieces_.whole(x, y_), face, lights, own_pieces_);
  }
}

void FlatRows::paint(int x, const Piece& piece, int face, int lights, Pieces& pieces) {
  const auto lines = pattern_lines(frame_, frame_.faces[face], piece, pieces);
  if (!(lines[0].count() + lines[1].count() <= most_lines)) {
    paint_fine(x, piece, face, lights, pieces);
    return;
  }
  std::vector<Piece> cells{piece};
  for (const int axis : {0, 1}) {
    for (double cell = lines[axis].first + 1; cell <= lines[axis].last; ++cell) {
      const view::Linear line = pattern_line(frame_, frame_.faces[face], axis, cell);
      const std::size_t count = cells.size();
      for (std::size_t i = 0; i < count; ++i) {
        const Sides sides = pieces.cut(cells[i], line);
        if (sides.inside.count == 0 || sides.outside.count == 0) continue;
        cells[i] = sides.inside;
        cells.push_back(sides.outside);
      }
    }
  }
  for (const Piece& cell : cells) paint_cell(x, cell, face, lights, pieces);
}

/// One cell of the pattern.
void FlatRows::paint_cell(int x, const Piece& piece, int face, int lights, Pieces& pieces) {
  const view::ScreenPoint middle = pieces.centroid(piece);
  const double area = pieces.area(piece);
  if (is_uncertain(lights) || turns(frame_.faces[face], x, piece, pieces)) {
    if (area == 1) {
      integrator_->add_pixel(x, y_, source(face, lights));
      return;
    }
    integrator_->add_piece(x, y_, screen_piece(pieces, piece, source(face, lights)));
    return;
  }
  const int parts = highlight_parts(frame_, frame_.faces[face], light_sets_.lights(lights), piece, pieces);
  if (parts > 1)
    paint_parts(x, piece, face, lights, parts, pieces);
  else
    paint_sample(x, middle, area, face, lights);
}

void FlatRows::paint_sample(int x, const view::ScreenPoint& at, double area, int face, int lights) {
  const FlatSample sample =
      shade_flat(frame_, frame_.faces[face], light_sets_.lights(lights), at.x, at.y, counts_->rays);
  Row& row = (*band_)[y_ - top_];
  row.radiance[x] += area * sample.radiance;
  row.notes[x].signature += signature_of(face, light_sets_.lights(lights), sample.signature);
  ++row.notes[x].samples;
  ++counts_->samples;
}

/// A highlight that one sample would not do justice to.
void FlatRows::paint_parts(int x, const Piece& piece, int face, int lights, int parts, Pieces& pieces) {
  Piece below = piece;
  for (int j = 1; j <= parts && below.count > 0; ++j) {
    const Sides strips =
        j < parts ? pieces.cut(below, view::Linear{0, -1, y_ + j / (1.0 * parts)}) : Sides{below, {}};
    below = strips.outside;
    Piece right = strips.inside;
    for (int i = 1; i <= parts && right.count > 0; ++i) {
      const Sides sides =
          i < parts ? pieces.cut(right, view::Linear{-1, 0, x + i / (1.0 * parts)}) : Sides{right, {}};
      right = sides.outside;
      if (sides.inside.count > 0)
        paint_sample(x, pieces.centroid(sides.inside), pieces.area(sides.inside), face, lights);
    }
  }
}

/// So many cells that half of the piece has each colour, up to one part in most_lines.
void FlatRows::paint_fine(int x, const Piece& piece, int face, int lights, Pieces& pieces) {
  const view::ScreenPoint middle = pieces.centroid(piece);
  const scene::Material& material =
      frame_.world.materials[frame_.world.bodies[frame_.faces[face].body].material];
  const core::Color albedo = (material.diffuse + material.checker->color) / 2.0;
  Row& row = (*band_)[y_ - top_];
  row.radiance[x] += pieces.area(piece) * shade_flat(frame_, frame_.faces[face], light_sets_.lights(lights),
                                                     middle.x, middle.y, counts_->rays, albedo)
                                              .radiance;
  ++row.notes[x].samples;
  ++counts_->samples;
}

} // namespace halftone::scan
