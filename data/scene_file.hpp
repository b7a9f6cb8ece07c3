#pragma once
#include <filesystem>
#include <string>

#include "data/scene.hpp"

namespace nipref::data {

/// Reads a scene from a TOML file and checks it. Numbers are doubles, as TOML says: both paths then take the
/// same numbers exactly.
///
///     title = "..."               wanted = ["contact_length", ...]    names out of scene_results()
///     accuracy = 1e-10            optional
///     [roller]   radius           [sheet] thickness
///     [material] model = "elastic", young, poisson
///     [load]     per_length       or [contact] length
///     [friction] model = "none" or "full"; creep_ratio, optional: line loads with full friction only
///     [method]   kind = "converged", or kind = "line-loads", leading_elements, trailing_elements and
///                residue_terms (optional)
///     [profile]  points or positions = [...]: where the profiles are wanted, if any are
///
/// Throws BadInput "FILE:LINE: KEY = VALUE: ALLOWED" for a file that cannot be read or is no TOML, for an
/// unknown or missing key (its table's line, or no line), a wrong type, and whatever Scene::check refuses.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file);

/// The file of a scene that comes with the library, e.g. "thick-full-friction": it is in the folder "scenes"
/// beside tables_directory(). BadInput if there is none of that name.
[[nodiscard]] std::filesystem::path example_scene(const std::string& name);

}  // namespace nipref::data
