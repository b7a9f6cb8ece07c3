#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

/// Returns "did you mean A? " or "did you mean A, B or C? " for the first `most` of the candidates that the fewest
/// typing errors turn into `name`; empty if none is near. An error is a letter left out, added or replaced, or an
/// exchange of neighbours. There may be one, or as many as a third of the letters, but not all. Upper and lower case
/// are the same. If a name of three letters or more is a part of the candidate, this is one error.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates,
                                       std::size_t most = 1);

}  // namespace nipref::data
