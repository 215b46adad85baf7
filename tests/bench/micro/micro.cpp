// halftone-micro: times of single kernels. Google Benchmark's own arguments choose and repeat them
// (--benchmark_filter=, --benchmark_repetitions=, --benchmark_format=json).

#include "micro.h"

#include <benchmark/benchmark.h>

using namespace halftone;

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  // Everything is registered here and nowhere else: what is to be timed in several ways is added once for
  // each.
  micro::add_lines();
  micro::add_refracted_rays();
  micro::add_rows();
  micro::add_shadows();
  micro::add_stream();
  micro::add_pictures();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
