#pragma once
// How much a long test does where a sanitizer makes it ten times slower: every assertion with every bound, on
// fewer seeds and pictures. Other builds run all of them.

#include <cstdint>

namespace halftone::test {

#ifdef HALFTONE_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// Every one of so many seeds. Coprime with the periods (2 to 6) by which seeds choose what a scene has.
inline constexpr std::uint64_t seed_step = sanitized ? 7 : 1;

/// The tag of a case that no sanitizer runs unasked.
inline constexpr const char* long_when_sanitized = sanitized ? "[.][long]" : "[unsanitized]";

} // namespace halftone::test
