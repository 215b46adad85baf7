// A picture written as PNG, to a file that is whole or as it was. An item is a pixel.

#include "micro.h"

#include <halftone/png/png.h>

#include <benchmark/benchmark.h>

#include <filesystem>

namespace halftone::micro {

namespace {

void time_writing(benchmark::State& state, const png::Picture& picture) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "halftone-micro.png";
  for (auto _ : state) png::write(file, picture, png::Encoding::srgb);
  std::filesystem::remove(file);
  state.SetItemsProcessed(state.iterations() * picture.width * picture.height);
}

} // namespace

void add_pictures() {
  benchmark::RegisterBenchmark("png/fig9a", time_writing,
                               png::read(HALFTONE_SOURCE_DIR "/tests/golden/fig9a.png"))
      ->Unit(benchmark::kMillisecond);
}

} // namespace halftone::micro
