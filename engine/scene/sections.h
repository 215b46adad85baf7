#pragma once
// The readers of a scene file's sections. Each takes the section's value and returns it read and validated,
// or throws core::InputError.

#include "table.h"

#include <halftone/scene/scene.h>

#include <string>
#include <string_view>
#include <vector>

namespace halftone::scene {

Image read_image(const Field& field);
Camera read_camera(const Field& field);
Trace read_trace(const Field& field);

/// [background] and [ambient]: a table of one color.
Color read_surroundings(const Field& field);

std::vector<Light> read_lights(const Field& field);

/// The default grey, then those of the file.
std::vector<Material> read_materials(const std::optional<Field>& field);

/// The objects in file order; materials as read_materials returned them, facets of the stand-ins.
std::vector<Object> read_objects(const Field& field, const std::vector<Material>& materials, int facets);

/// Keys of a shape besides those that all objects have. Refuses a word that is no shape, or none yet.
std::vector<std::string_view> keys_of_shape(const Field& word);

Shape read_shape(const std::string& word, const Table& table);

} // namespace halftone::scene
