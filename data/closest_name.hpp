#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

/// "did you mean A? " or "did you mean A, B or C? " for the first `most` of those candidates that the fewest
/// typing errors turn into `name`, otherwise nothing. An error is a letter left out, added or exchanged, or two
/// in the wrong order; there may be one, or as many as a third of the letters, but not all of them. Upper and
/// lower case are the same. What is left off before or behind three letters or more is one error.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates,
                                       std::size_t most = 1);

}  // namespace nipref::data
