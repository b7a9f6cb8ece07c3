#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/scene/file.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

// Options that several verbs read, or their defaults in the table of verbs.

fast::Accuracy accuracy_option(const CommandLine& line);
/// 0 if it is not given and has no default; "1e4" is a whole number too.
std::size_t points_option(const CommandLine& line);
/// The number of random scenes that an audit of contacts draws.
std::size_t scenes_option(const CommandLine& line);
/// The text from which random arguments are drawn.
std::string seed_option(const CommandLine& line);

/// What is in the file that a verb's one word names, or, where there is no such file, in that of an example; and the
/// path.
struct SceneRequest {
  data::SceneText scene;
  std::optional<int> digits;  ///< of ref; nothing: by fast
};
SceneRequest scene_request(const CommandLine& line);

/// By how much something may be slower than what --against names, 0.1 for "10%" or "0.1"; none if it is not said.
std::optional<double> max_slowdown_option(const CommandLine& line);

/// Nothing if it is not given and has no default.
std::optional<int> digits_option(const CommandLine& line);
/// Every how many-th row is looked at.
std::size_t every_option(const CommandLine& line);

/// BadInput, saying `why`, if this option or flag is there.
void refuse_option(const CommandLine& line, const std::string& name, const std::string& why);

/// What the words name, each once: quantities of the catalogue, and groups that are not in it; all of it if
/// there are none.
struct Selection {
  std::vector<const Quantity*> quantities;
  std::vector<std::string_view> groups;

  [[nodiscard]] bool has(std::string_view group) const;
};
/// BadInput for words that are neither a quantity nor one of `groups`.
Selection selection(const CommandLine& line, const std::vector<std::string_view>& groups);

}  // namespace nipref::verify
