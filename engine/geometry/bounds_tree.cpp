// Bounding volume hierarchy by the surface area heuristic in bins (I. Wald, "On fast construction of
// SAH-based bounding volume hierarchies", 2007), walked by slabs (T. Kay, J. Kajiya 1986). Ours takes boxes
// that reach to infinity too: they stand in leaves of their own, at the root, and count for nothing in the
// heuristic.
//
// Invariant: a node's box contains those of all of its items, exactly: minima and maxima are not rounded. So
// a walk that goes by boxes leaves out nothing that asking all boxes would find.

#include <halftone/geometry/bounds_tree.h>

#include <algorithm>
#include <cmath>

namespace halftone::geometry {

namespace {

constexpr int bins = 16;
constexpr std::size_t most_in_leaf = 4;
/// From this depth on halves have equal numbers: 2^31 items are no deeper than most_depth.
constexpr int even_depth = 32;

bool is_empty(const Bounds& box) { return !(box.low.x <= box.high.x); }

bool is_bounded(const Bounds& box) {
  const Vec3 size = box.high - box.low;
  return std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z);
}

/// Half the surface, which is proportional to the share of lines that pass.
double area(const Bounds& box) {
  const Vec3 size = box.high - box.low;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

int widest_axis(const Bounds& box) {
  const Vec3 size = box.high - box.low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

struct Bin {
  Bounds box;
  int count = 0;
};

} // namespace

struct BoundsTree::Building {
  Bounds box;
  Vec3 middle{0};
  int item = 0;
};

BoundsTree::BoundsTree(std::span<const Bounds> boxes) {
  std::vector<Building> building;
  for (int item = 0; item < static_cast<int>(boxes.size()); ++item)
    if (!is_empty(boxes[item]))
      building.push_back({boxes[item], boxes[item].low + (boxes[item].high - boxes[item].low) / 2.0, item});
  if (building.empty()) return;
  items_.reserve(building.size());
  boxes_.reserve(building.size());
  const auto unbounded = std::stable_partition(building.begin(), building.end(),
                                               [](const Building& each) { return is_bounded(each.box); });
  const std::span<Building> all(building), bounded = all.first(unbounded - building.begin());
  const std::span<Building> rest = all.subspan(bounded.size());
  if (rest.empty()) {
    build(bounded, 0);
  } else {
    // An inner node of both, or a leaf.
    Node root;
    for (const Building& each : all) root.box.include(each.box);
    if (!bounded.empty()) {
      nodes_.push_back(root);
      build(bounded, 1);
      nodes_[0].second = static_cast<int>(nodes_.size());
    }
    Node leaf{root.box};
    leaf.first = static_cast<int>(items_.size());
    leaf.count = static_cast<int>(rest.size());
    nodes_.push_back(leaf);
    for (const Building& each : rest) {
      items_.push_back(each.item);
      boxes_.push_back(each.box);
    }
  }
  nodes_.shrink_to_fit();
}

void BoundsTree::build(std::span<Building> items, int depth) {
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Bounds box, middles;
  for (const Building& each : items) {
    box.include(each.box);
    middles.include({each.middle, each.middle});
  }
  nodes_[at].box = box;
  const int axis = widest_axis(middles);
  const double low = middles.low[axis], width = middles.high[axis] - low;
  if (items.size() <= most_in_leaf) {
    nodes_[at].first = static_cast<int>(items_.size());
    nodes_[at].count = static_cast<int>(items.size());
    for (const Building& each : items) {
      items_.push_back(each.item);
      boxes_.push_back(each.box);
    }
    return;
  }

  std::size_t half = items.size() / 2;
  const double per_width = bins / width;
  if (depth < even_depth && width > 0 && std::isfinite(per_width)) {
    const auto bin_of = [&](const Building& each) {
      return std::min(bins - 1, static_cast<int>((each.middle[axis] - low) * per_width));
    };
    std::array<Bin, bins> all;
    for (const Building& each : items) {
      Bin& bin = all[bin_of(each)];
      bin.box.include(each.box);
      ++bin.count;
    }
    // The cost of the upper part of each cut, then that of the lower one added. The first and the last bin
    // have items, so both parts do.
    std::array<double, bins> cost{};
    Bin part;
    for (int k = bins - 1; k > 0; --k) {
      part.box.include(all[k].box);
      part.count += all[k].count;
      cost[k] = area(part.box) * part.count;
    }
    part = {};
    for (int k = 1; k < bins; ++k) {
      part.box.include(all[k - 1].box);
      part.count += all[k - 1].count;
      cost[k] += area(part.box) * part.count;
    }
    const auto cut = static_cast<int>(std::min_element(cost.begin() + 1, cost.end()) - cost.begin());
    const auto upper = std::stable_partition(items.begin(), items.end(),
                                             [&](const Building& each) { return bin_of(each) < cut; });
    half = static_cast<std::size_t>(upper - items.begin());
  } else {
    std::stable_sort(items.begin(), items.end(),
                     [&](const Building& a, const Building& b) { return a.middle[axis] < b.middle[axis]; });
  }
  nodes_[at].axis = axis;
  build(items.first(half), depth + 1);
  nodes_[at].second = static_cast<int>(nodes_.size());
  build(items.subspan(half), depth + 1);
}

} // namespace halftone::geometry
