#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/scene/file.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/golden/make.hpp>

namespace nipref::verify {

// Golden contacts: a row has all results of one contact. A kind of contacts is a scene with a sweep,
// data/golden/contacts-KIND.toml; its rows are in contacts-KIND.csv beside it.

/// The names of all kinds, "contacts-frictionless" and so on, in alphabetical order.
std::vector<std::string> contact_kinds();
bool is_contact_kind(std::string_view name);
/// The kind's scene. BadInput if there is no such kind.
data::SceneText contact_scene(std::string_view kind);

/// All combinations of the values in the scene's own sweep.
AxesProduct swept_by(const data::SceneText& scene);

/// The names of the keys that vary; below, those of the results.
std::vector<std::string> contact_keys(std::string_view kind);
std::vector<std::string> contact_results(std::string_view kind);

/// The digits that the reference is asked for; its values have three more.
inline constexpr int contact_digits = 17;

/// Solves every contact of the kind by the reference. fast confirms each: its stated error must cover the difference. A
/// second method confirms those that it covers: a tenth of the nips, evenly spaced, and all bodies on half-spaces.
MadeGolden make_contacts(const std::string& kind, int digits, const Provenance& provenance,
                         const OnProgress& progress);

/// Solves one contact of each group of `options.every` rows again by fast, and a tenth of these, one at least, or all
/// by the reference, and compares them with the file.
CheckedGolden check_contacts(const GoldenFile& file, const CheckOptions& options);

}  // namespace nipref::verify
