#pragma once
#include <string>
#include <vector>

#include <nipref/data/scene/file.hpp>
#include <nipref/data/scene/internal/scene_table.hpp>

// Readers of the parts of a scene's file. They throw BadInput that names the key; `origin` is that of the tables.

namespace nipref::data {

/// Returns material.model. Throws BadInput unless there is such a model.
[[nodiscard]] std::string material_model(const SceneTable& material);
/// The material of a rolling nip: any model, "elastic" included.
[[nodiscard]] ViscoelasticMaterial read_viscoelastic_material(const SceneTable& material,
                                                              const SceneOrigin& origin);
/// Reads a whole file about a half-space.
[[nodiscard]] HalfSpaceProblem read_half_space_problem(const SceneTable& file, const SceneOrigin& origin);

[[nodiscard]] Profile read_profile(const SceneTable& profile, const SceneOrigin& origin);
[[nodiscard]] FieldPlaces read_field(const SceneTable& field);
/// The table [sweep] of a whole file, if it has one.
[[nodiscard]] SceneSweep read_sweep(const SceneTable& file, const SceneOrigin& origin);
/// The results with these names. BadInput, with the nearest names, for an unknown one.
[[nodiscard]] std::vector<ResultId> read_wanted(const std::vector<std::string>& names, SceneKind kind,
                                                const SceneOrigin& origin);

}  // namespace nipref::data
