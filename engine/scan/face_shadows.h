#pragma once
// The shadows on a face drawn by scanlines, ready for rows.

#include "stretches.h"

#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
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

/// The shadows on the faces of a frame, each found when it is first asked for. For several threads at once:
/// those who ask for the shadows on the same face share the lights among them.
class FaceShadows {
public:
  /// The frame must outlive this.
  explicit FaceShadows(const Frame& frame);

  struct OnFace {
    std::vector<FaceShadow> all;
    geometry::BoundsTree rows; ///< row_bounds of their outlines
  };

  /// All that can fall on the side of the face that is seen; lights behind it need none. Adds to the number
  /// of casters that the face was compared with by this call.
  const OnFace& on(int face, std::uint64_t& comparisons);

private:
  struct Shared {
    std::atomic<int> claimed = 0; ///< lights that somebody looks after
    std::atomic<int> found = 0;   ///< lights that are done with
    std::mutex failing;           ///< guards failure
    std::exception_ptr failure;   ///< the first, of whoever looked after a light
    std::once_flag joined;
    std::vector<std::vector<FaceShadow>> of_light;
    OnFace on_face;
  };

  std::vector<FaceShadow> find(const ScreenFace& face, int light, std::uint64_t& comparisons) const;

  const Frame& frame_;
  shadow::Shadows shadows_;
  std::vector<Shared> of_face_;
};

} // namespace halftone::scan
