#pragma once
#include <nipref/data/problem/field_places.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>

namespace nipref::data {

FieldPlaces read_field(const TomlTable& field);

/// Throws BadInput that names the key unless every number is in its domain and there are 1 to 100000 places.
void check_field(const FieldPlaces& field, const SceneOrigin& origin);

}  // namespace nipref::data
