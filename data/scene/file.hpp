#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/scene/scene.hpp>

namespace nipref::data {

/// Keys with their values, as they are given on a command line: {"load.per_length", "200"}.
using SceneOverrides = std::vector<std::pair<std::string, std::string>>;

/// The text of a scene, not yet parsed: a pipe can be read only once, however many contacts its scene stands for.
struct SceneText {
  std::string name;  ///< name of the file, for messages
  std::string toml;
};

/// Reads the text of a scene. Throws BadInput if the file cannot be read (input_file.hpp) or is longer than a mebibyte.
[[nodiscard]] SceneText read_scene(const std::filesystem::path& file);
/// The same for the file of this name or, if there is none, for the example of this name.
[[nodiscard]] SceneText read_scene_or_example(const std::string& name);

/// Reads a scene from a TOML file and checks it. Numbers are doubles, as TOML says, so that both paths take the same
/// numbers exactly. These are the keys of nips without Coulomb's friction; scene_keys() has all keys.
///
///     title = "..."               wanted = ["contact_length", ...]    names out of scene_results()
///     accuracy = 1e-10            optional
///     [roller]   radius           [sheet] thickness
///     [material] model = "elastic", young, poisson
///                or, with [rolling] speed, the material of a viscoelastic sheet: model = "elastic", or
///                "standard-linear-solid", bulk, shear, relaxation_time, or shear_1, shear_2, bulk_1, bulk_2,
///                shear_viscosity, bulk_viscosity; "prony", theta1_instantaneous, theta1_amplitudes = [...],
///                theta1_rates = [...], theta2_... likewise; "operators", P, Q, P_dilatation, Q_dilatation =
///                [...], the coefficient of p^0 first; "thesis-misprint", bulk, relaxation_time, shear
///                (optional, 3/8 bulk), the misprinted solid of the thesis. See viscoelastic.hpp
///     [rolling]  speed            friction.model is then "none"
///     [load]     per_length       or [contact] length
///     [friction] model = "none" or "full"; creep_ratio, optional: line loads with full friction only
///     [method]   kind = "converged", or kind = "line-loads", leading_elements, trailing_elements and
///                residue_terms (optional); when rolling also approach_lengths, and trailing_elements is
///                optional
///     [profile]  points or positions = [...]: where the profiles are wanted, if any are
///     [field]    positions = [...] along the sheet and depths = [...], -1 to 1 over half the thickness: where fields
///                inside the sheet are wanted, if any are
///     [sweep]    keys with several values, see SceneSweep: then `overrides` must have one for each
///
/// Throws BadInput as read_scene does, and BadInput "FILE:LINE: KEY = VALUE: ALLOWED" for a file that is not TOML, an
/// unknown or missing key (with the line of its table, if any), a wrong type, and whatever Scene::check refuses.
///
/// `overrides` replace the values that the file has at these keys, or add keys: "TABLE.KEY" or "KEY" with a number, a
/// text (quotes may be left out) or a list in TOML's notation. Each adds ", with KEY = VALUE" to the title. They are
/// checked like the file; BadInput "KEY = VALUE: ALLOWED" shows them as they were given. An empty key, a key
/// given twice and a table are refused.
[[nodiscard]] Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {});

/// The same for a scene that was read already.
[[nodiscard]] Scene load_scene(const SceneText& given, const SceneOverrides& overrides);

/// The same for the text of a file; refusals name the file `name`.
[[nodiscard]] Scene parse_scene(const std::string& toml, const std::string& name);

/// The file of an example scene of the library, e.g. "thick-full-friction", in scenes_directory(). Throws BadInput,
/// which suggests the nearest names, if there is none of this name.
[[nodiscard]] std::filesystem::path example_scene(const std::string& name);

/// The table [sweep] of a scene's file: the values that keys take. There is a contact for each combination of them.
///
///     [sweep]  load.per_length = [50, 100, 200] or "1..1000:log", any other key of the scene likewise
///              points: values of each range, 1 to 1e7, optional
struct SceneSweep {
  /// {"load.per_length", "50, 100, 200" or "1..1000:log"}, in the order of the alphabet.
  std::vector<std::pair<std::string, std::string>> keys;
  std::optional<int> points;
};

/// Reads the table [sweep] of a scene; without it the result has no keys. Throws BadInput "FILE:LINE: KEY = VALUE:
/// ALLOWED" for a text that is not TOML and for values that are neither a text nor a list of numbers or texts.
[[nodiscard]] SceneSweep scene_sweep(const SceneText& scene);

}  // namespace nipref::data
