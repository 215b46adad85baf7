#pragma once
// Why a pixel of the screen looks as it does.

#include <halftone/inspect/memory.h>

namespace halftone::inspect {

/// What decides a pixel of the screen.
enum class Decider { image, overlay, cursor, border, blank };

std::string_view name_of(Decider decider);

struct Seen {
  Decider decider = Decider::image;
  Place source;            ///< the image pixel that lies there, seen or covered
  device::Pixel memory{};  ///< its value
  device::Pixel masked{};  ///< after the read mask
  device::Pixel through{}; ///< after the look-up tables, too
  device::Pixel color{};   ///< what is seen
};

/// At a column and a row of the screen, 0 to 511, in the clock's present field.
Seen seen_at(const device::Device& device, std::uint16_t x, std::uint16_t y);

} // namespace halftone::inspect
