#pragma once
// Which of two bodies is in front wherever they overlap on the screen.

#include <halftone/geometry/bounding.h>

#include <unordered_map>
#include <vector>

namespace halftone::order {

enum class Front {
  first, ///< the first body hides the second wherever both are seen
  second,
  varies, ///< they may pass through each other: compare depths
};

/// Relations are found when they are first asked for, and remembered. Not for use by several threads at once.
class Order {
public:
  /// Both must outlive this. hulls: one for each body.
  Order(const scene::World& world, const std::vector<geometry::Hull>& hulls) : world_(world), hulls_(hulls) {}

  Front compare(int first, int second);

  /// Pairs whose relation was found so far.
  std::size_t known() const { return known_.size(); }

private:
  Front find(int first, int second) const;

  const scene::World& world_;
  const std::vector<geometry::Hull>& hulls_;
  std::unordered_map<std::uint64_t, Front> known_;
};

/// Of two opaque bodies whose faces coincide, whether the first is the one that is seen: a polygon before a
/// solid, otherwise the one last in the file.
bool is_seen_before(const scene::World& world, int first, int second);

} // namespace halftone::order
