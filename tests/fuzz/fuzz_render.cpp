// Any scene that the reader accepts is drawn in every mode: each row once, from the top, of radiances that
// are numbers and not negative. An input that is no scene file is the numbers of a made one; the title says
// how a scene is drawn.

#include "made_scene.h"
#include "read.h"
#include "small_scene.h"

#include <halftone/render/render.h>

#include <cmath>
#include <cstdlib>
#include <string>

using namespace halftone;

namespace {

render::Settings settings(const std::string& title) {
  FuzzedDataProvider fuzz(reinterpret_cast<const std::uint8_t*>(title.data()), title.size());
  using render::Mode;
  render::Settings settings;
  settings.threads = 1;
  settings.mode = fuzz.PickValueInArray({Mode::local, Mode::scanline, Mode::full, Mode::reference});
  settings.samples = fuzz.ConsumeIntegralInRange(1, 2);
  if (fuzz.ConsumeBool()) settings.lines = fuzz.ConsumeIntegralInRange(1, 3);
  settings.quality = fuzz.PickValueInArray({0.25, 2.0, 8.0});
  using render::Show;
  if (fuzz.ConsumeIntegralInRange(0, 15) == 1)
    settings.show = fuzz.PickValueInArray({Show::intervals, Show::samples, Show::cost});
  return settings;
}

void draw(const scene::Scene& scene, const render::Settings& settings) {
  int rows = 0;
  render::render(scene, settings, [&](const render::Row& row) {
    if (row.y != rows++ || std::ssize(row.radiance) != scene.image.width) std::abort();
    for (const core::Color& radiance : row.radiance)
      for (int channel = 0; channel < 3; ++channel)
        if (!std::isfinite(radiance[channel]) || radiance[channel] < 0) std::abort();
  });
  if (rows != scene.image.height) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  auto scene = fuzz::read({bytes, bytes + size});
  if (!scene) scene = fuzz::SceneMaker(bytes, size).make();
  if (!scene) return 0;
  fuzz::make_small(*scene);
  draw(*scene, settings(scene->title));
  return 0;
}
