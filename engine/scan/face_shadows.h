#pragma once
// The shadows on a face drawn by scanlines, ready for rows.

#include "stretches.h"

#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace halftone::scan {

/// Where one caster stands between one light and a face.
struct FaceShadow {
  int light = 0;
  int caster = 0;
  bool dark = false;     ///< all of it; otherwise points have to be tested
  bool anywhere = false; ///< the outline is not known
  Outline outline;
};

/// Ways in which the lights can reach a face, as small numbers. 0: all unhindered.
class LightSets {
public:
  explicit LightSets(std::size_t lights) : sets_{std::vector<Lighting>(lights)}, signatures_{0} {}

  /// The set with a light darkened, or with one more caster to be tested.
  int with(int set, const FaceShadow& shadow);

  /// Forgets all but 0.
  void clear();

  const std::vector<Lighting>& lights(int set) const { return sets_[set]; }

private:
  std::vector<std::vector<Lighting>> sets_;
  std::vector<std::uint64_t> signatures_; ///< of each set, whatever the order that it was reached in
  std::unordered_multimap<std::uint64_t, int> by_signature_;
  std::map<std::tuple<int, int, int, bool>, int> known_;
};

/// All that can fall on the side of the face that is seen; lights behind it need none.
std::vector<FaceShadow> shadows_of(const Frame& frame, shadow::Shadows& shadows, const ScreenFace& face);

} // namespace halftone::scan
