#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace nipref::data {

/// "did you mean CANDIDATE? " for the candidate that the fewest typing errors turn into `name` (letters left
/// out, added or exchanged; at most a third of them), otherwise nothing.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       const std::vector<std::string_view>& candidates);

}  // namespace nipref::data
