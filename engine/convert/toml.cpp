#include <halftone/convert/toml.h>

#include "words.h"

#include <array>
#include <string_view>

namespace halftone::convert {

namespace {

using core::Vec3;

std::string quoted(std::string_view text) {
  constexpr std::string_view hex = "0123456789ABCDEF";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += "\\u00";
      result += hex[byte >> 4];
      result += hex[byte & 15];
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string array_of(const Vec3& v) { return text(v, '[', ']'); }

std::string array_of(const std::vector<Vec3>& points) {
  std::string result = "[";
  for (const Vec3& p : points) result += (result.size() > 1 ? ", " : "") + array_of(p);
  return result + "]";
}

std::string array_of(const std::vector<std::vector<int>>& loops) {
  std::string result = "[";
  for (const std::vector<int>& loop : loops) {
    result += result.size() > 1 ? ", [" : "[";
    for (std::size_t i = 0; i < loop.size(); ++i) result += (i > 0 ? ", " : "") + std::to_string(loop[i]);
    result += "]";
  }
  return result + "]";
}

/// Lines of "key = value".
class Keys {
public:
  explicit Keys(const std::string& table) : text_("\n" + table + "\n") {}

  Keys& raw(std::string_view key, const std::string& value) {
    text_.append(key).append(" = ").append(value).append("\n");
    return *this;
  }
  Keys& add(std::string_view key, double value) { return raw(key, text(value)); }
  Keys& add(std::string_view key, int value) { return raw(key, std::to_string(value)); }
  Keys& add(std::string_view key, const Vec3& value) { return raw(key, array_of(value)); }
  Keys& add(std::string_view key, const std::string& value) { return raw(key, quoted(value)); }

  const std::string& str() const { return text_; }

private:
  std::string text_;
};

void add_shape(Keys& keys, const scene::Object& object) {
  if (const auto* s = std::get_if<scene::Sphere>(&object.shape)) {
    keys.add("center", s->center).add("radius", s->radius);
  } else if (const auto* f = std::get_if<scene::Frustum>(&object.shape)) {
    keys.add("base", f->base).add(object.shape_name == "cone" ? "apex" : "top", f->top);
    if (object.shape_name == "frustum")
      keys.add("base_radius", f->base_radius).add("top_radius", f->top_radius);
    else
      keys.add("radius", f->base_radius);
  } else if (const auto* b = std::get_if<scene::Box>(&object.shape)) {
    keys.add("min", b->min).add("max", b->max);
  } else if (const auto* p = std::get_if<scene::Prism>(&object.shape)) {
    keys.add("base", p->base).add("top", p->top).add("radius", p->radius);
    keys.add("sides", p->sides).add("turn", p->turn);
  } else if (const auto* solid = std::get_if<scene::Polyhedron>(&object.shape)) {
    keys.raw("vertices", array_of(solid->vertices)).raw("faces", array_of(solid->faces));
  } else {
    keys.raw("vertices", array_of(std::get<scene::Polygon>(object.shape).vertices));
  }
}

std::string table_of(const scene::Material& material) {
  Keys keys("[material." + quoted(material.name) + "]");
  keys.add("diffuse", material.diffuse).add("specular", material.specular);
  keys.add("shininess", material.shininess);
  if (material.glass)
    keys.add("ior", material.glass->ior).add("absorption", material.glass->absorption);
  else
    keys.add("mirror", material.mirror);
  keys.add("opaque", material.opaque);
  if (const auto& checker = material.checker) {
    constexpr std::string_view letters = "xyz";
    const std::string axes{letters[checker->axis_a], letters[checker->axis_b]};
    keys.raw("checker", "{ color = " + array_of(checker->color) + ", size = " + text(checker->size) +
                            ", axes = " + quoted(axes) + " }");
  }
  return keys.str();
}

std::string table_of(const scene::Object& object, const std::vector<scene::Material>& materials) {
  constexpr std::array<const char*, 3> rules{"auto", "always", "never"};
  Keys keys("[[object]]");
  keys.add("shape", object.shape_name);
  if (!object.name.empty()) keys.add("name", object.name);
  if (object.material > 0) keys.add("material", materials[object.material].name);
  keys.add("trace", std::string(rules[static_cast<std::size_t>(object.trace)]));
  add_shape(keys, object);
  keys.add("scale", object.placement.scale).add("rotate", object.placement.rotate);
  keys.add("translate", object.placement.translate);
  return keys.str();
}

} // namespace

std::string toml(const scene::Scene& scene) {
  std::string result = "format = 1\ntitle = " + quoted(scene.title) + "\n";
  result +=
      Keys("[image]")
          .add("width", scene.image.width)
          .add("height", scene.image.height)
          .add("exposure", scene.image.exposure)
          .add("transfer", std::string(scene.image.transfer == scene::Transfer::srgb ? "srgb" : "linear"))
          .str();
  result += Keys("[camera]")
                .add("eye", scene.camera.eye)
                .add("target", scene.camera.target)
                .add("up", scene.camera.up)
                .add("fov", scene.camera.fov)
                .str();
  result += Keys("[background]").add("color", scene.background).str();
  result += Keys("[ambient]").add("color", scene.ambient).str();
  result += Keys("[trace]")
                .add("depth", scene.trace.depth)
                .add("cutoff", scene.trace.cutoff)
                .add("facets", scene.trace.facets)
                .str();
  for (const scene::Light& light : scene.lights)
    result += Keys("[[light]]").add("position", light.position).add("color", light.color).str();
  for (std::size_t i = 1; i < scene.materials.size(); ++i) result += table_of(scene.materials[i]);
  for (const scene::Object& object : scene.objects) result += table_of(object, scene.materials);
  return result;
}

} // namespace halftone::convert
