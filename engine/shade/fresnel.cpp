#include <halftone/shade/fresnel.h>

#include <halftone/core/elementary.h>

namespace halftone::shade {

Color transmittance(const Color& absorption, double length) {
  if (absorption == core::black) return Color{1};
  return {core::exp(-absorption.r * length), core::exp(-absorption.g * length),
          core::exp(-absorption.b * length)};
}

} // namespace halftone::shade
