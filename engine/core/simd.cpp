#include <halftone/core/simd.h>

namespace halftone::core {

std::string_view name(Simd simd) {
  switch (simd) {
  case Simd::baseline:
    return "baseline";
  case Simd::avx2:
    return "avx2";
  case Simd::avx512:
    return "avx512";
  }
  return {};
}

Simd widest_simd() {
#if defined(__x86_64__)
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512cd");
  return avx512 ? Simd::avx512 : avx2 ? Simd::avx2 : Simd::baseline;
#else
  return Simd::baseline;
#endif
}

} // namespace halftone::core
