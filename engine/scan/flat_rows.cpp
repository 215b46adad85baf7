// Shadows cut what is seen like edges do: on a flat receiver the shadow of a flat caster is a polygon on the
// screen, that of a round one is bounded by conics, replaced by chords that leave less than Frame::sagitta.
// What lies between is constant in what it sees, and has one sample at its centroid, or more where light
// varies in it.

#include "flat_rows.h"

#include "pattern.h"
#include "variation.h"

#include <halftone/core/mixed.h>
#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <array>

namespace halftone::scan {

namespace {

/// More lines of a pattern than this in a pixel are not cut, but averaged.
constexpr double most_lines = 64;
/// Pixels that are looked at together, at most.
constexpr int run_length = FlatPoints::capacity;

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
  painters_.clear();
  light_sets_.clear();
  in_row_.clear();
  last_ = nullptr;
}

void FlatRows::begin_row(int y) { y_ = y; }

void FlatRows::finish() {
  for (auto& [paint, painter] : painters_) shade_waiting(painter);
}

const FlatRows::RowOfFace& FlatRows::in_row(int face) {
  if (last_ && last_face_ == face && last_->y == y_) return *last_;
  RowOfFace& row = in_row_[face];
  last_ = &row;
  last_face_ = face;
  if (row.y == y_) return row;
  row.y = y_;
  row.shadows.find(shadows_.on(face, comparisons), y_, frame_.world.camera.width, comparisons);
  row.is_steady = is_steady(face);
  return row;
}

bool FlatRows::is_steady(int face) const {
  const ScreenFace& drawn = frame_.faces[face];
  if (frame_.world.bodies[drawn.body].faces[drawn.face].rounded) return false;
  const PixelRange touched = frame_.face_outlines[face].in_row(y_).touched;
  const PixelRange seen{std::max(touched.begin, 0), std::min(touched.end, frame_.world.camera.width)};
  return !seen.is_empty() &&
         !may_vary(frame_, drawn, light_sets_.lights(0), seen, y_, missed_, Within::pieces);
}

bool FlatRows::is_uncertain(int lights) const {
  const auto& list = light_sets_.lights(lights);
  return std::any_of(list.begin(), list.end(), [](const Lighting& l) { return !l.casters.empty(); });
}

/// So many cells that half of a piece has each colour, up to one part in most_lines.
std::optional<core::Color> FlatRows::albedo(const Paint& paint) const {
  if (!paint.averaged) return std::nullopt;
  const scene::Material& material =
      frame_.world.materials[frame_.world.bodies[frame_.faces[paint.face].body].material];
  return (material.diffuse + material.checker->color) / 2.0;
}

int FlatRows::source(const Paint& paint) {
  const auto [known, is_new] = sources_.try_emplace(paint, 0);
  if (is_new)
    known->second =
        integrator_->add_source({{}, paint.face, light_sets_.lights(paint.lights), albedo(paint)});
  return known->second;
}

void FlatRows::add_pixels(PixelRange pixels, int face) {
  const RowShadows& shadows = in_row(face).shadows;
  breaks_ = {pixels.begin, pixels.end};
  for (int x = pixels.begin; x < pixels.end;) {
    const PixelRange block = shadows.block_of(x);
    for (const int k : shadows.at(x)) {
      const RowOutline& row = shadows[k].row;
      for (const int end : {row.touched.begin, row.full.begin, row.full.end, row.touched.end})
        if (end > pixels.begin && end < pixels.end && end >= block.begin && end <= block.end)
          breaks_.push_back(end);
    }
    x = block.end;
  }
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const PixelRange run{breaks_[i], breaks_[i + 1]};
    int lights = 0;
    bool partial = false;
    for (const int k : shadows.at(run.begin)) {
      const RowShadow& shadow = shadows[k];
      if (!shadow.row.touched.contains(run.begin)) continue;
      if (light_sets_.lights(lights)[shadow.shadow->light].dark) continue;
      if (shadow.row.full.contains(run.begin))
        lights = light_sets_.with(lights, *shadow.shadow);
      else
        partial = true;
    }
    if (!partial) {
      for (int x = run.begin; x < run.end; x += run_length)
        paint(PixelRange{x, std::min(x + run_length, run.end)}, face, lights);
      continue;
    }
    for (int x = run.begin; x < run.end; ++x) add_piece(x, own_pieces_.whole(x, y_), face, own_pieces_);
  }
}

void FlatRows::add_piece(int x, const Piece& piece, int face, Pieces& pieces) {
  lit_.clear();
  lit_.push_back({piece, 0});
  const RowShadows& shadows = in_row(face).shadows;
  comparisons += shadows.at(x).size();
  for (const int k : shadows.at(x)) {
    const RowShadow& shadow = shadows[k];
    if (!shadow.row.touched.contains(x)) continue;
    const std::size_t count = lit_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Lit part = lit_[i];
      if (light_sets_.lights(part.lights)[shadow.shadow->light].dark) continue;
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
        lit_[i] = {inside, light_sets_.with(part.lights, *shadow.shadow)};
    }
  }
  for (std::size_t i = 0; i < lit_.size(); ++i) paint(x, lit_[i].piece, face, lit_[i].lights, pieces);
}

/// Whether a stand-in's round normal turns away from the eye within the piece.
bool FlatRows::turns(const ScreenFace& face, const Piece& piece, const Pieces& pieces) const {
  if (!frame_.world.bodies[face.body].faces[face.face].rounded) return false;
  int turned = 0;
  for (int k = 0; k < piece.count; ++k) {
    const view::ScreenPoint p = pieces.corner(piece, k);
    turned += is_turned(frame_, face, p.x, p.y) ? 1 : 0;
  }
  return turned != 0 && turned != piece.count;
}

void FlatRows::paint(PixelRange pixels, int face, int lights) {
  if (pixels.end - pixels.begin > 1) {
    if (paint_run(pixels, face, lights)) return;
    const int middle = pixels.begin + (pixels.end - pixels.begin) / 2;
    paint(PixelRange{pixels.begin, middle}, face, lights);
    paint(PixelRange{middle, pixels.end}, face, lights);
  } else {
    paint(pixels.begin, own_pieces_.whole(pixels.begin, y_), face, lights, own_pieces_);
  }
}

/// Pixels with one sample each, if it is certain of all of them that they need no more.
bool FlatRows::paint_run(PixelRange pixels, int face, int lights) {
  const ScreenFace& drawn = frame_.faces[face];
  const auto& list = light_sets_.lights(lights);
  if (frame_.world.bodies[drawn.body].faces[drawn.face].rounded || is_uncertain(lights) ||
      has_pattern_lines(frame_, drawn, pixels, y_) ||
      (!in_row(face).is_steady && may_vary(frame_, drawn, list, pixels, y_, missed_, Within::pixels)))
    return false;
  const FlatRun& run = painter_of({face, lights}).run;
  const auto [albedo, shading] = run.reflecting({pixels.begin + 0.5, y_ + 0.5}); // one cell of the pattern
  FlatPoints points;
  for (int x = pixels.begin; x < pixels.end; ++x) points.add({x + 0.5, y_ + 0.5}, albedo);
  std::array<core::Color, FlatPoints::capacity> radiance;
  run.shade(points, radiance);
  const std::uint64_t signature = signature_of(face, list, shading);
  Row& row = (*band_)[y_ - top_];
  for (int x = pixels.begin; x < pixels.end; ++x) {
    row.radiance[x] += radiance[x - pixels.begin];
    row.notes[x].signature += signature;
    ++row.notes[x].samples;
  }
  counts_->samples += points.count;
  return true;
}

void FlatRows::paint(int x, const Piece& piece, int face, int lights, Pieces& pieces) {
  const auto lines = pattern_lines(frame_, frame_.faces[face], piece, pieces);
  if (!(lines[0].count() + lines[1].count() <= most_lines)) {
    paint_cell(x, piece, {face, lights, true}, pieces);
    return;
  }
  cells_.assign(1, piece);
  for (const int axis : {0, 1}) {
    for (double cell = lines[axis].first + 1; cell <= lines[axis].last; ++cell) {
      const view::Linear line = pattern_line(frame_, frame_.faces[face], axis, cell);
      const std::size_t count = cells_.size();
      for (std::size_t i = 0; i < count; ++i) {
        const Sides sides = pieces.cut(cells_[i], line);
        if (sides.inside.count == 0 || sides.outside.count == 0) continue;
        cells_[i] = sides.inside;
        cells_.push_back(sides.outside);
      }
    }
  }
  for (const Piece& cell : cells_) paint_cell(x, cell, {face, lights}, pieces);
}

/// One cell of the pattern, or many: in quarters, as long as its middle does not stand for the light on it.
void FlatRows::paint_cell(int x, const Piece& piece, const Paint& paint, Pieces& pieces) {
  const ScreenFace& face = frame_.faces[paint.face];
  if (!in_row(paint.face).is_steady && pieces.area(piece) > core::least_cut &&
      varies(frame_, face, light_sets_.lights(paint.lights), piece, pieces, missed_)) {
    const view::ScreenPoint middle = pieces.centroid(piece);
    const Sides halves = pieces.cut(piece, view::Linear{0, -1, middle.y});
    for (const Piece& half : {halves.inside, halves.outside}) {
      if (half.count == 0) continue;
      const Sides quarters = pieces.cut(half, view::Linear{-1, 0, middle.x});
      for (const Piece& quarter : {quarters.inside, quarters.outside})
        if (quarter.count > 0) paint_cell(x, quarter, paint, pieces);
    }
    return;
  }
  if (!is_uncertain(paint.lights) && !turns(face, piece, pieces))
    paint_sample(x, pieces.centroid(piece), pieces.area(piece), paint);
  else if (pieces.area(piece) == 1)
    integrator_->add_pixel(x, y_, source(paint));
  else
    integrator_->add_piece(x, y_, integrator_->screen_piece(pieces, piece, source(paint)));
}

FlatRows::Painter& FlatRows::painter_of(const Paint& paint) {
  const auto known = painters_.find(paint);
  if (known != painters_.end()) return known->second;
  const FlatRun run(frame_, frame_.faces[paint.face], light_sets_.lights(paint.lights), albedo(paint));
  return painters_.emplace(paint, Painter{run, {}}).first->second;
}

void FlatRows::shade_waiting(Painter& painter) {
  FlatPoints points;
  for (const Waiting& sample : painter.waiting) points.add(sample.at, sample.albedo);
  std::array<core::Color, FlatPoints::capacity> radiance;
  painter.run.shade(points, radiance);
  for (std::size_t k = 0; k < points.count; ++k) {
    const Waiting& sample = painter.waiting[k];
    (*band_)[sample.y - top_].radiance[sample.x] += sample.area * radiance[k];
  }
  painter.waiting.clear();
}

void FlatRows::paint_sample(int x, const view::ScreenPoint& at, double area, const Paint& paint) {
  const auto& lights = light_sets_.lights(paint.lights);
  const ScreenFace& face = frame_.faces[paint.face];
  Row& row = (*band_)[y_ - top_];
  std::uint64_t shading = 0;
  if (frame_.world.bodies[face.body].faces[face.face].rounded) {
    const FlatSample sample = shade_flat(frame_, face, lights, at.x, at.y, counts_->rays, albedo(paint));
    row.radiance[x] += area * sample.radiance;
    shading = sample.signature;
  } else {
    Painter& painter = painter_of(paint);
    const auto [own, signature] = painter.run.reflecting(at);
    painter.waiting.push_back({x, y_, at, area, own});
    if (painter.waiting.size() == FlatPoints::capacity) shade_waiting(painter);
    shading = signature;
  }
  row.notes[x].signature += signature_of(paint.face, lights, shading);
  ++row.notes[x].samples;
  ++counts_->samples;
}

} // namespace halftone::scan
