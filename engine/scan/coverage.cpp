// Area coverage resolved from what is visible (E. Catmull, "A hidden-surface algorithm with anti-aliasing",
// 1978; K. Weiler, P. Atherton 1977), instead of by virtual scanlines: a row falls into runs of pixels
// through which no visible edge passes, and single pixels, whose square is cut by the edges that do. Edges
// behind what fills a run do not count. Where faces pass through each other, the line on which their depths
// agree is an edge like any other, since 1/depth is linear on the screen.
//
// Invariant: the parts tile the row; in a part everything in front is the same at every point. No certificate
// is needed that nothing else enters, because every edge that passes through a pixel has cut it.

#include "coverage.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace halftone::scan {

namespace {

/// Corners of a run, relative to its top left.
std::array<view::ScreenPoint, 4> rectangle_of(PixelRange run) {
  const double width = run.end - run.begin;
  return {{{0, 0}, {width, 0}, {width, 1}, {0, 1}}};
}

view::Linear difference(const view::Linear& a, const view::Linear& b) {
  return {a.a - b.a, a.b - b.b, a.c - b.c};
}

} // namespace

const Outline& Coverage::outline_of(const Shape& shape) const {
  return shape.face >= 0 ? frame_.face_outlines[shape.face] : frame_.traced_shapes[shape.traced].outline;
}

void Coverage::collect(int y) {
  shapes_.clear();
  const int faces = static_cast<int>(frame_.face_outlines.size());
  frame_.shape_rows.meeting(row_bounds(y), [&](int number) {
    ++comparisons;
    Shape shape{number < faces ? number : -1, number < faces ? -1 : number - faces, {}};
    const Outline& outline = outline_of(shape);
    if (!(outline.top < y + 1 && outline.bottom > y)) return;
    shape.row = outline.in_row(y);
    if (!shape.row.touched.is_empty()) shapes_.push_back(std::move(shape));
  });
  std::sort(shapes_.begin(), shapes_.end(), [](const Shape& a, const Shape& b) {
    return a.row.touched.begin != b.row.touched.begin ? a.row.touched.begin < b.row.touched.begin
           : a.face != b.face                         ? a.face < b.face
                                                      : a.traced < b.traced;
  });
}

/// Which of two faces is in front over all of a convex part of the screen, given relative to (x, y).
order::Front Coverage::compare(int face, int other, std::span<const view::ScreenPoint> corners, double x,
                               double y) {
  const ScreenFace &a = frame_.faces[face], &b = frame_.faces[other];
  if (a.body != b.body) {
    const order::Front front = order_.compare(a.body, b.body);
    if (front != order::Front::varies) return front;
  }
  const view::Linear nearer = difference(a.inverse_depth, b.inverse_depth);
  const double here = nearer.at(x, y);
  bool before = false, behind = false;
  for (const view::ScreenPoint& p : corners) {
    const double height = nearer.a * p.x + (nearer.b * p.y + here);
    before = before || height > 0;
    behind = behind || height < 0;
  }
  if (before && behind) return order::Front::varies;
  if (!before && !behind)
    return order::is_seen_before(frame_.world, a.body, b.body) ? order::Front::first : order::Front::second;
  return before ? order::Front::first : order::Front::second;
}

void Coverage::cover(int y, CoverageSink& sink) {
  collect(y);
  const int width = frame_.world.camera.width;
  std::vector<int> breaks{0, width};
  for (const Shape& shape : shapes_)
    for (const int x :
         {shape.row.touched.begin, shape.row.full.begin, shape.row.full.end, shape.row.touched.end})
      if (x > 0 && x < width) breaks.push_back(x);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());

  open_.clear();
  std::size_t next = 0;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const PixelRange run{breaks[i], breaks[i + 1]};
    for (; next < shapes_.size() && shapes_[next].row.touched.begin <= run.begin; ++next)
      open_.push_back(static_cast<int>(next));
    std::erase_if(open_, [&](int s) { return shapes_[s].row.touched.end <= run.begin; });
    cover_run(run, y, sink);
  }
}

/// Behind the face that fills the run, everywhere in it.
bool Coverage::is_hidden(const Shape& shape, int nearest, std::span<const view::ScreenPoint> rectangle) {
  const int body = frame_.faces[nearest].body;
  if (shape.traced >= 0)
    return order_.compare(body, frame_.traced_shapes[shape.traced].body) == order::Front::first;
  return shape.face != nearest && compare(nearest, shape.face, rectangle, 0, 0) == order::Front::first;
}

void Coverage::cover_run(PixelRange run, int y, CoverageSink& sink) {
  auto rectangle = rectangle_of(run);
  for (view::ScreenPoint& p : rectangle) p = {p.x + run.begin, p.y + y};
  const auto fills = [&](int s) { return shapes_[s].row.full.contains(run.begin); };

  int nearest = -1;
  bool settled = true;
  for (const int s : open_) {
    const int face = shapes_[s].face;
    if (face < 0 || !fills(s)) continue;
    if (nearest < 0) {
      nearest = face;
      continue;
    }
    const order::Front front = compare(face, nearest, rectangle, 0, 0);
    if (front == order::Front::varies) settled = false;
    if (front == order::Front::first) nearest = face;
  }
  front_ = open_;
  if (nearest >= 0 && settled)
    std::erase_if(front_, [&](int s) { return is_hidden(shapes_[s], nearest, rectangle); });

  // A traced body that fills the run hides the faces behind it.
  for (const int t : front_) {
    if (shapes_[t].traced < 0 || !fills(t)) continue;
    const TracedShape& traced = frame_.traced_shapes[shapes_[t].traced];
    if (!traced.certain) continue;
    const auto is_behind = [&](int face) {
      return order_.compare(traced.body, frame_.faces[face].body) == order::Front::first;
    };
    std::vector<int> left;
    for (const int s : front_)
      if (shapes_[s].face < 0 || !is_behind(shapes_[s].face)) left.push_back(s);
    if (left.size() == front_.size()) continue;
    front_ = left;
    if (nearest >= 0 && is_behind(nearest)) nearest = -1;
    break;
  }

  const bool whole = std::all_of(front_.begin(), front_.end(), [&](int s) {
    return fills(s) && (shapes_[s].face < 0 || shapes_[s].face == nearest);
  });
  if (!whole || !settled) {
    for (int x = run.begin; x < run.end; ++x) cover_pixel(x, y, sink);
    return;
  }
  InFront seen{nearest, 0};
  for (const int s : front_)
    if (shapes_[s].traced >= 0)
      seen.traced = sets_.with(seen.traced, frame_.traced_shapes[shapes_[s].traced].body);
  sink.add_pixels(run, seen);
}

/// The part of a piece within the shape; what is outside becomes parts of its own. Empty where they do not
/// meet: then nothing has changed.
Piece Coverage::clipped(const Shape& shape, const Piece& piece, int x, const InFront& rest) {
  const std::size_t parts_before = parts_.size();
  Piece inside = piece;
  for (const RowEdge& edge : shape.row.edges) {
    if (!edge.pixels.contains(x)) continue;
    const Sides sides = pieces_.cut(inside, edge.edge);
    if (sides.inside.count == 0) {
      parts_.resize(parts_before);
      return {};
    }
    if (sides.outside.count > 0) parts_.push_back({sides.outside, rest});
    inside = sides.inside;
  }
  return inside;
}

void Coverage::insert_face(const Shape& shape, int x, int y) {
  const std::size_t count = parts_.size();
  comparisons += count;
  for (std::size_t i = 0; i < count; ++i) {
    const Part part = parts_[i];
    const int other = part.seen.face;
    if (other >= 0 && compare(shape.face, other, pieces_.corners(part.piece), x, y) == order::Front::second)
      continue;
    const Piece inside = clipped(shape, part.piece, x, part.seen);
    if (inside.count == 0) continue;
    const order::Front front =
        other < 0 ? order::Front::first : compare(shape.face, other, pieces_.corners(inside), x, y);
    if (front == order::Front::varies) {
      const Sides sides = pieces_.cut(
          inside, difference(frame_.faces[shape.face].inverse_depth, frame_.faces[other].inverse_depth));
      parts_[i] = {sides.inside.count > 0 ? sides.inside : sides.outside,
                   {sides.inside.count > 0 ? shape.face : other, 0}};
      if (sides.inside.count > 0 && sides.outside.count > 0) parts_.push_back({sides.outside, {other, 0}});
    } else {
      parts_[i] = {inside, {front == order::Front::first ? shape.face : other, 0}};
    }
  }
}

void Coverage::insert_traced(const Shape& shape, int x) {
  const int body = frame_.traced_shapes[shape.traced].body;
  const std::size_t count = parts_.size();
  comparisons += count;
  for (std::size_t i = 0; i < count; ++i) {
    const Part part = parts_[i];
    if (part.seen.face >= 0 && order_.compare(frame_.faces[part.seen.face].body, body) == order::Front::first)
      continue;
    const Piece inside = clipped(shape, part.piece, x, part.seen);
    if (inside.count > 0) parts_[i] = {inside, {part.seen.face, sets_.with(part.seen.traced, body)}};
  }
}

void Coverage::cover_pixel(int x, int y, CoverageSink& sink) {
  // Downwards: mirrored regions are inserted in the same order.
  std::sort(front_.begin(), front_.end(), [&](int a, int b) {
    const Outline &p = outline_of(shapes_[a]), &q = outline_of(shapes_[b]);
    return std::tuple(p.top, p.bottom, a) < std::tuple(q.top, q.bottom, b);
  });
  parts_.clear();
  parts_.push_back({pieces_.whole(x, y), {}});
  for (const int s : front_)
    if (shapes_[s].face >= 0) insert_face(shapes_[s], x, y);
  for (const int s : front_)
    if (shapes_[s].face < 0) insert_traced(shapes_[s], x);
  sink.add_parts(x, parts_, pieces_);
}

} // namespace halftone::scan
