#pragma once
#include <functional>
#include <map>
#include <string_view>

#include <nipref/verify/seeds/errata.hpp>

namespace nipref::verify {

/// By the erratum's id.
using Settlements = std::map<std::string_view, std::function<Settlement()>>;

Settlements thesis_settlements();
Settlements half_space_settlements();

}  // namespace nipref::verify
