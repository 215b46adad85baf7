// halftone info: what a scene holds, and what of it will be ray traced.

#include "commands.h"

#include <halftone/scene/read.h>
#include <halftone/scene/world.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace halftone::cli {

namespace {

struct Options {
  std::string scene;
  bool json = false;
};

std::string_view kind(const scene::Material& material) {
  if (material.glass) return "glass";
  return core::max_component(material.mirror) > 0 ? "mirror" : "opaque";
}

std::string name_of(const scene::Material& material) {
  return material.name.empty() ? "(default)" : material.name;
}

std::string_view transfer_of(const scene::Image& image) {
  return image.transfer == scene::Transfer::srgb ? "srgb" : "linear";
}

/// Why mode local traces rays for an object, or why it does not.
std::string_view reason(const scene::Object& object, const scene::Material& material) {
  if (object.trace == scene::TraceRule::never) return "never";
  if (material.glass || kind(material) == "mirror") return kind(material);
  const bool round = std::holds_alternative<scene::Sphere>(object.shape) ||
                     std::holds_alternative<scene::Frustum>(object.shape);
  if (round) return "round";
  return object.trace == scene::TraceRule::always ? "always" : "flat";
}

using Bounds = std::array<core::Vec3, 2>;

/// Of all objects; a scene without any has none.
std::optional<Bounds> bounds_of(const scene::World& world) {
  if (world.bodies.empty()) return std::nullopt;
  Bounds all = world.bodies.front().bounds;
  for (const scene::Body& body : world.bodies)
    all = {glm::min(all[0], body.bounds[0]), glm::max(all[1], body.bounds[1])};
  return all;
}

std::string text_of(const core::Vec3& v) {
  std::ostringstream text;
  text << '(' << v.x << ", " << v.y << ", " << v.z << ')';
  return text.str();
}

std::string text_of(const Bounds& bounds) { return text_of(bounds[0]) + " to " + text_of(bounds[1]); }

std::string for_people(const scene::Scene& scene, const scene::World& world) {
  std::ostringstream text;
  text << std::left;
  if (!scene.title.empty()) text << "title      " << terminal::one_line(scene.title) << '\n';
  text << "image      " << scene.image.width << " x " << scene.image.height << ", exposure "
       << scene.image.exposure << ", " << transfer_of(scene.image) << '\n';
  text << "camera     eye " << text_of(scene.camera.eye) << ", target " << text_of(scene.camera.target)
       << ", fov " << scene.camera.fov << '\n';
  text << "trace      depth " << scene.trace.depth << ", cutoff " << scene.trace.cutoff << ", facets "
       << scene.trace.facets << '\n';
  if (const auto bounds = bounds_of(world)) text << "bounds     " << text_of(*bounds) << '\n';

  text << "lights     " << scene.lights.size() << '\n';
  for (const scene::Light& light : scene.lights)
    text << "  at " << text_of(light.position) << ", color " << text_of(light.color) << '\n';

  text << "materials  " << scene.materials.size() << '\n';
  for (const scene::Material& material : scene.materials) {
    text << "  " << std::setw(12) << terminal::one_line(name_of(material)) << ' ' << kind(material);
    if (material.glass) text << ", ior " << material.glass->ior;
    text << '\n';
  }

  const auto traced =
      std::count_if(world.bodies.begin(), world.bodies.end(), [](const auto& body) { return body.traced; });
  text << "objects    " << scene.objects.size() << ", " << traced << " of them traced\n";
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    const scene::Material& material = scene.materials[static_cast<std::size_t>(object.material)];
    text << "  " << std::setw(3) << i + 1 << ' ' << std::setw(10) << object.shape_name << ' ' << std::setw(12)
         << terminal::one_line(name_of(material)) << ' '
         << (world.bodies[i].traced ? "traced (" : "scanlines (") << reason(object, material) << ')';
    if (!object.name.empty()) text << "  " << terminal::one_line(object.name);
    text << '\n';
  }
  return text.str();
}

nlohmann::ordered_json json_of(const core::Vec3& v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json json_of(const Bounds& bounds) { return {json_of(bounds[0]), json_of(bounds[1])}; }

std::string as_json(const scene::Scene& scene, const scene::World& world) {
  using Json = nlohmann::ordered_json;
  Json lights = Json::array(), materials = Json::array(), objects = Json::array();
  for (const scene::Light& light : scene.lights)
    lights.push_back({{"position", json_of(light.position)}, {"color", json_of(light.color)}});
  for (const scene::Material& material : scene.materials)
    materials.push_back({{"name", material.name}, {"kind", kind(material)}});
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const scene::Object& object = scene.objects[i];
    objects.push_back({{"name", object.name},
                       {"shape", object.shape_name},
                       {"material", object.material},
                       {"traced", world.bodies[i].traced},
                       {"reason", reason(object, scene.materials[static_cast<std::size_t>(object.material)])},
                       {"bounds", json_of(world.bodies[i].bounds)}});
  }
  const auto bounds = bounds_of(world);
  const Json object = {
      {"title", scene.title},
      {"width", scene.image.width},
      {"height", scene.image.height},
      {"exposure", scene.image.exposure},
      {"transfer", transfer_of(scene.image)},
      {"camera",
       {{"eye", json_of(scene.camera.eye)},
        {"target", json_of(scene.camera.target)},
        {"up", json_of(scene.camera.up)},
        {"fov", scene.camera.fov}}},
      {"trace",
       {{"depth", scene.trace.depth}, {"cutoff", scene.trace.cutoff}, {"facets", scene.trace.facets}}},
      {"bounds", bounds ? json_of(*bounds) : Json()},
      {"lights", lights},
      {"materials", materials},
      {"objects", objects},
  };
  return object.dump(2) + "\n";
}

ExitCode run(const Options& options) {
  const scene::Scene scene = scene::read_scene(options.scene);
  const scene::World world = scene::make_world(scene);
  std::cout << (options.json ? as_json(scene, world) : for_people(scene, world));
  return ExitCode::done;
}

} // namespace

Command add_info(Arguments program) {
  Arguments command =
      program.add_subcommand("info", "Tell what a scene holds, and what of it will be ray traced");
  const auto options = std::make_shared<Options>();
  command.add_option("SCENE", options->scene, "Scene file (.toml)").required().type_name("");
  command.add_flag("--json", options->json, "Print it as one JSON object");
  command.footer("Example:\n  halftone info scenes/fig9b.toml");
  return {command, [options] { return run(*options); }};
}

} // namespace halftone::cli
