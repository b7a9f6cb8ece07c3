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

// Golden contacts: what one kind of contact gives, all its results in a row. A kind is a scene with a sweep,
// data/golden/contacts-KIND.toml; its rows are in contacts-KIND.csv beside it.

/// The names of all kinds, "contacts-frictionless" and so on, in the order of the alphabet.
std::vector<std::string> contact_kinds();
bool is_contact_kind(std::string_view name);
/// The kind's scene. BadInput if there is no such kind.
data::SceneText contact_scene(std::string_view kind);

/// All combinations of what the scene's own sweep has.
AxesProduct swept_by(const data::SceneText& scene);

/// The names of the keys that vary, and those of the results.
std::vector<std::string> contact_keys(std::string_view kind);
std::vector<std::string> contact_results(std::string_view kind);

/// The digits that the reference is asked for; its values have three more.
inline constexpr int contact_digits = 17;

/// Solves every contact of the kind by the reference, and confirms it by fast, whose error must cover; and, as far as it
/// reaches, by a second method: a tenth of the nips, evenly spaced, and all bodies on half-spaces.
MadeGolden make_contacts(const std::string& kind, int digits, const Provenance& provenance,
                         const OnProgress& progress);

/// Solves contacts of a file again and compares: those that are looked at by fast, a tenth of them, one at least, or all,
/// by the reference.
CheckedGolden check_contacts(const GoldenFile& file, const CheckOptions& options);

}  // namespace nipref::verify
