#pragma once
#include <string>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/data/scene/internal/toml_table.hpp>
#include <nipref/data/scene/origin.hpp>

namespace nipref::data {

/// material.model; BadInput unless it is one that there is.
[[nodiscard]] std::string material_model(const TomlTable& material);

/// The material of a rolling nip: any model, "elastic" included. BadInput naming the scene's key.
[[nodiscard]] ViscoelasticMaterial read_viscoelastic_material(const TomlTable& material,
                                                              const SceneOrigin& origin);

}  // namespace nipref::data
