#pragma once
// What light travels in.

#include <halftone/core/memory.h>
#include <halftone/scene/world.h>

#include <vector>

namespace halftone::trace {

struct Medium {
  double index = 1; ///< of refraction
  core::Color absorption{0};
  bool is_glass = false;
};

/// The media of a world by body, -1 being air.
class Media {
public:
  explicit Media(const scene::World& world) : media_(1) {
    for (const scene::Body& body : world.bodies) {
      const auto& glass = world.materials[body.material].glass;
      media_.push_back(glass ? Medium{glass->ior, glass->absorption, true} : Medium{});
    }
  }

  const Medium& operator[](int body) const { return media_[body + 1]; }

  /// Bytes that they hold.
  std::size_t memory() const { return core::memory_of(media_); }

private:
  std::vector<Medium> media_;
};

} // namespace halftone::trace
