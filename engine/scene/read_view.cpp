// What is seen, from where, in what light and how: all sections but materials and objects.

#include "sections.h"

#include <halftone/core/rounding.h>

namespace halftone::scene {

namespace {

/// Refuses views without a direction or without an upright.
void check_view(const Table& table, const Camera& camera) {
  // Coordinates were rounded when they were read (1 each), their difference adds 1, its length 4: an eye and
  // a target nearer than that may be the same point, and their direction may be off by as much of their
  // distance.
  const double distance = glm::distance(camera.eye, camera.target);
  const double rounding = core::gamma(8) * (glm::length(camera.eye) + glm::length(camera.target));
  const Field target = *table.find("target");
  if (distance <= rounding || distance < smallest_number)
    fail(target, "\"target\" is at \"eye\"", "the camera looks from eye to target, so they must differ");

  const std::optional<Field> up = table.find("up");
  if (glm::length(camera.up) < smallest_number)
    fail(up.value_or(target), "\"up\" in camera has no direction", "write a vector such as [0, 0, 1]");

  const double sine =
      glm::length(glm::cross(glm::normalize(camera.target - camera.eye), glm::normalize(camera.up)));
  // As much again for the unit vectors and their product: the distance is at most the sum of the two lengths.
  if (sine <= 2 * rounding / distance)
    fail(up.value_or(target), "\"up\" in camera is parallel to the view from eye to target",
         "choose an up that the camera does not look along, such as [0, 1, 0] for a view along z");
}

} // namespace

Image read_image(const Field& field) {
  constexpr int largest_side = 512; // the frame buffer's
  const Table table(field, "image", {"width", "height", "exposure", "transfer"},
                    "write [image] in single brackets");
  Image image;
  if (const auto width = table.find("width")) image.width = integer(*width, 1, largest_side);
  if (const auto height = table.find("height")) image.height = integer(*height, 1, largest_side);
  if (const auto exposure = table.find("exposure")) image.exposure = number(*exposure, Bound::positive);
  if (const auto transfer = table.find("transfer"))
    image.transfer = choice<Transfer>(*transfer, {{"srgb", Transfer::srgb}, {"linear", Transfer::linear}});
  return image;
}

Camera read_camera(const Field& field) {
  const Table table(field, "camera", {"eye", "target", "up", "fov"}, "write [camera] in single brackets");
  Camera camera;
  camera.eye = vector(table.at("eye", "eye = [4, -6, 3], the point to look from"));
  camera.target = vector(table.at("target", "target = [0, 0, 1], the point to look at"));
  if (const auto up = table.find("up")) camera.up = vector(*up);
  if (const auto fov = table.find("fov")) {
    camera.fov = number(*fov, Bound::positive);
    if (camera.fov >= 180) refuse(*fov, "degrees below 180", "40 is a usual field of view, 90 a wide one");
  }
  check_view(table, camera);
  return camera;
}

Trace read_trace(const Field& field) {
  // A tree of depth 1,000 is never complete. A ring of 1,024 sides is within 5e-6 of its circle's radius, and
  // no picture of 512 pixels can tell more; a sphere then has half a million faces.
  constexpr int greatest_depth = 1000;
  constexpr int most_facets = 1024;
  const Table table(field, "trace", {"depth", "cutoff", "facets"}, "write [trace] in single brackets");
  Trace trace;
  if (const auto depth = table.find("depth")) trace.depth = integer(*depth, 1, greatest_depth);
  if (const auto cutoff = table.find("cutoff")) trace.cutoff = number(*cutoff, Bound::fraction);
  if (const auto facets = table.find("facets")) trace.facets = integer(*facets, 3, most_facets);
  return trace;
}

Color read_surroundings(const Field& field) {
  const std::string name(field.key);
  const Table table(field, name, {"color"}, "write [" + name + "], then color = [0.5, 0.5, 0.5]");
  const auto radiance = table.find("color");
  return radiance ? color(*radiance, Bound::not_negative) : core::black;
}

std::vector<Light> read_lights(const Field& field) {
  std::vector<Light> lights;
  constexpr std::string_view advice = "write [[light]] in double brackets";
  for (const Value& element : array(field, "tables", advice)) {
    const Table table({element, field.file, field.table, field.key}, "light", {"position", "color"}, advice);
    Light light;
    light.position = vector(table.at("position", "position = [-5, -6, 9]"));
    light.color = color(table.at("color", "color = [1, 1, 1]"), Bound::not_negative);
    lights.push_back(light);
  }
  return lights;
}

} // namespace halftone::scene
