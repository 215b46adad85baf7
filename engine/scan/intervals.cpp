// The scanline's visible intervals (Tadamura, Nakamae, Nishita c. 1986, section 3.3): all ends of all faces'
// extents are sorted, and between two neighbouring ends the order relations say what is in front. Where two
// bodies pass through each other, the interval is split where their depths cross, so cycles and
// interpenetration need nothing special.
//
// Invariant: the intervals tile [0, width]; an interval's face is nearest among faces in all of its interior.

#include "intervals.h"

#include <algorithm>

namespace halftone::scan {

namespace {

struct End {
  double x = 0;
  bool begins = false;
  bool is_face = false;
  int index = 0;
};

class Line {
public:
  Line(const Frame& frame, order::Order& order, double y) : frame_(frame), order_(order), y_(y) {}

  void add_ends(const Active& active) {
    for (const int f : active.faces) add(view::extent_at(frame_.faces[f].outline, y_), true, f);
    for (const int t : active.traced) {
      std::optional<view::Extent> whole;
      for (const view::ScreenPolygon& outline : frame_.traced[t].outlines) {
        const auto extent = view::extent_at(outline, y_);
        if (!extent) continue;
        if (!whole) whole = extent;
        whole->left = std::min(whole->left, extent->left);
        whole->right = std::max(whole->right, extent->right);
      }
      add(whole, false, t);
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      return a.x != b.x ? a.x < b.x : a.is_face != b.is_face ? a.is_face : a.index < b.index;
    });
  }

  std::vector<Interval> walk() {
    double at = 0;
    std::vector<int> faces, traced;
    for (const End& end : ends_) {
      if (end.x > at) {
        resolve(at, end.x, faces, traced);
        at = end.x;
      }
      std::vector<int>& open = end.is_face ? faces : traced;
      if (end.begins)
        open.push_back(end.index);
      else
        open.erase(std::find(open.begin(), open.end(), end.index));
    }
    const double width = frame_.world.camera.width;
    if (at < width) resolve(at, width, faces, traced);
    return std::move(intervals_);
  }

private:
  /// Between corners on the screen's edge an end may round past it.
  void add(const std::optional<view::Extent>& extent, bool is_face, int index) {
    if (!extent) return;
    const double width = frame_.world.camera.width;
    const double left = std::max(extent->left, 0.0), right = std::min(extent->right, width);
    if (!(left < right)) return;
    ends_.push_back({left, true, is_face, index});
    ends_.push_back({right, false, is_face, index});
  }

  /// Differences of the coefficients first: then it is monotonic in x, rounding included, and has one change
  /// of sign.
  double depth_difference(int a, int b, double x) const {
    const view::Linear& f = frame_.faces[a].inverse_depth;
    const view::Linear& g = frame_.faces[b].inverse_depth;
    return view::Linear{f.a - g.a, f.b - g.b, f.c - g.c}.at(x, y_);
  }

  /// Whether face a hides face b over the whole of [left, right]; where their depths cross inside, the
  /// crossing.
  bool hides(int a, int b, double left, double right, std::optional<double>& crossing) {
    const int body_a = frame_.faces[a].body, body_b = frame_.faces[b].body;
    if (body_a != body_b) {
      const order::Front front = order_.compare(body_a, body_b);
      if (front != order::Front::varies) return front == order::Front::first;
    }
    const double at_left = depth_difference(a, b, left), at_right = depth_difference(a, b, right);
    if (at_left == 0 && at_right == 0) return order::is_seen_before(frame_.world, body_a, body_b);
    if (at_left >= 0 && at_right >= 0) return true;
    if (at_left <= 0 && at_right <= 0) return false;
    const double x = left + (right - left) * (at_left / (at_left - at_right));
    if (x > left && x < right) crossing = x;
    return at_left + at_right > 0;
  }

  void resolve(double left, double right, const std::vector<int>& faces, const std::vector<int>& traced) {
    int nearest = -1;
    for (const int face : faces) {
      if (nearest < 0) {
        nearest = face;
        continue;
      }
      std::optional<double> crossing;
      if (hides(face, nearest, left, right, crossing)) nearest = face;
      if (!crossing) continue;
      resolve(left, *crossing, faces, traced);
      resolve(*crossing, right, faces, traced);
      return;
    }
    Interval interval{left, right, nearest, {}};
    for (const int t : traced) {
      const int body = frame_.traced[t].body;
      if (nearest >= 0 && order_.compare(frame_.faces[nearest].body, body) == order::Front::first) continue;
      interval.candidates.push_back(body);
    }
    std::sort(interval.candidates.begin(), interval.candidates.end());
    if (!intervals_.empty() && intervals_.back().face == nearest &&
        intervals_.back().candidates == interval.candidates)
      intervals_.back().right = right;
    else
      intervals_.push_back(std::move(interval));
  }

  const Frame& frame_;
  order::Order& order_;
  double y_;
  std::vector<End> ends_;
  std::vector<Interval> intervals_;
};

} // namespace

Active active_in(const Frame& frame, double top, double bottom) {
  Active active;
  for (int f = 0; f < static_cast<int>(frame.faces.size()); ++f)
    if (frame.faces[f].top <= bottom && frame.faces[f].bottom >= top) active.faces.push_back(f);
  for (int t = 0; t < static_cast<int>(frame.traced.size()); ++t)
    if (frame.traced[t].top <= bottom && frame.traced[t].bottom >= top) active.traced.push_back(t);
  return active;
}

std::vector<Interval> visible_intervals(const Frame& frame, const Active& active, order::Order& order,
                                        double y) {
  Line line(frame, order, y);
  line.add_ends(active);
  return line.walk();
}

} // namespace halftone::scan
