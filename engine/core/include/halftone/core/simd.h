#pragma once
// Instruction sets between which kernels choose at run time.

#include <string_view>

namespace halftone::core {

/// In ascending order; results have the same bits with any.
enum class Simd {
  baseline, ///< x86-64, or whatever the program was built for: the scalar code
  avx2,
  avx512, ///< F, VL, DQ, BW and CD
};

std::string_view name(Simd simd);

/// The last that the processor has.
Simd widest_simd();

} // namespace halftone::core
