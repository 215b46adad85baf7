#include <halftone/convert/povray.h>

#include "povray_parts.h"
#include "words.h"

#include <algorithm>

namespace halftone::convert {

std::string vector_of(const core::Vec3& v) { return text(v, '<', '>'); }

namespace {

/// POV-Ray's ray through (x, y), each from -1/2 to 1/2 over the picture, is direction + x right + y up, so
/// our own vectors twice over give the same pixel centres. Its left-handedness lies in its default `right`
/// alone, and with this one there is nothing to mirror.
std::string camera_of(const scene::CameraFrame& camera) {
  return "camera {\n  perspective\n  location " + vector_of(camera.eye) + "\n  direction " +
         vector_of(camera.forward) + "\n  right " + vector_of(2.0 * camera.right) + "\n  up " +
         vector_of(2.0 * camera.up) + "\n}\n";
}

std::string command_of(const scene::Image& image) {
  return "// povray +I<this file> +O<picture>.png +FN8 +W" + std::to_string(image.width) + " +H" +
         std::to_string(image.height) +
         (image.transfer == scene::Transfer::srgb ? " File_Gamma=srgb" : " File_Gamma=1.0") + " -D\n";
}

} // namespace

std::string povray(const scene::Scene& scene) {
  const scene::World world = scene::make_world(scene);
  const double exposure = scene.image.exposure; // radiance is linear in all that gives light
  std::string result = command_of(scene.image);
  result += "#version 3.7;\nglobal_settings {\n  assumed_gamma 1.0\n  max_trace_level " +
            std::to_string(std::min(scene.trace.depth, 256)) + "\n  adc_bailout " + text(scene.trace.cutoff) +
            "\n  ambient_light rgb " + vector_of(scene.ambient * exposure) + "\n}\nbackground { rgb " +
            vector_of(scene.background * exposure) + " }\n" + camera_of(world.camera);
  for (const scene::Light& light : scene.lights)
    result +=
        "light_source { " + vector_of(light.position) + " rgb " + vector_of(light.color * exposure) + " }\n";
  for (int i = 0; i < static_cast<int>(world.materials.size()); ++i) result += povray_material(world, i);
  for (const scene::Body& body : world.bodies) result += povray_body(world, body);
  return result;
}

} // namespace halftone::convert
