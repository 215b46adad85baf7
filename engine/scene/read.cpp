#include <halftone/scene/read.h>

#include "sections.h"
#include "suggestion.h"

#include <halftone/core/error.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <system_error>

namespace halftone::scene {

namespace {

/// The version of the format, before any key that another version may know.
void check_format(const Field& root) {
  constexpr std::int64_t version = 1;
  const Value::Members& members = std::get<Value::Members>(root.value.content);
  const auto format =
      std::find_if(members.begin(), members.end(), [](const Member& m) { return m.key == "format"; });
  if (format == members.end())
    fail(root, "missing key \"format\" in scene", "add format = 1 as the first line");
  const Field field{format->value, root.file, root.table, format->key};
  const auto* found = std::get_if<std::int64_t>(&format->value.content);
  if (found == nullptr || *found != version) refuse(field, "1", "this program reads scenes of format = 1");
}

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// Refuses a path at which there is no scene file to open.
void check_path(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 5> planned{".nff", ".obj", ".ply", ".gltf", ".glb"};
  const std::string name = file.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw core::InputError({name}, "no such file", "check the path");
  if (error) throw core::InputError({name}, "cannot be read: " + error.message(), "check the path");
  if (std::filesystem::is_directory(status))
    throw core::InputError({name}, "is a folder, expected a scene file", "name a .toml file in it");
  if (!std::filesystem::is_regular_file(status)) // a pipe without a writer would be waited for
    throw core::InputError({name}, "is not a regular file, expected a scene file",
                           "write the scene to a file");

  const std::string extension = extension_of(file);
  if (std::find(planned.begin(), planned.end(), extension) != planned.end())
    throw core::InputError({name}, "files of type " + extension + " are not supported yet",
                           "convert it to a .toml scene");
  if (extension != ".toml")
    throw core::InputError({name}, "expected a file of type .toml, found type " + in_quotes(extension),
                           "scenes are TOML files, named .toml");
}

std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad())
    throw core::InputError({file.string()}, "cannot be read", "check its permissions");
  return text;
}

} // namespace

Scene read_toml(std::string_view text, const std::string& name) {
  const Value document = parse_document(text, name);
  const Field field{document, name, "scene", "scene"};
  check_format(field);
  const Table root(
      field, "scene",
      {"format", "title", "image", "camera", "background", "ambient", "trace", "light", "material", "object"},
      "");
  Scene scene;
  if (const auto title = root.find("title")) scene.title = scene::text(*title);
  if (const auto image = root.find("image")) scene.image = read_image(*image);
  scene.camera = read_camera(root.at("camera", "[camera] with eye and target"));
  if (const auto background = root.find("background")) scene.background = read_surroundings(*background);
  if (const auto ambient = root.find("ambient")) scene.ambient = read_surroundings(*ambient);
  if (const auto trace = root.find("trace")) scene.trace = read_trace(*trace);
  if (const auto lights = root.find("light")) scene.lights = read_lights(*lights);
  scene.materials = read_materials(root.find("material"));
  if (const auto objects = root.find("object"))
    scene.objects = read_objects(*objects, scene.materials, scene.trace.facets);
  return scene;
}

Scene read_scene(const std::filesystem::path& file) {
  check_path(file);
  return read_toml(contents(file), file.string());
}

} // namespace halftone::scene
