#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Every quantity that both paths can compute, in the order in which they are listed. There is no other
/// list of them.
const std::vector<Quantity>& catalogue();

/// Throws BadInput for a quantity called `name`. The message suggests the nearest names of the catalogue and of
/// `groups`, the other words that are allowed in its place.
[[noreturn]] void refuse_quantity(std::string_view name, const std::vector<std::string_view>& groups = {});

/// The entry of that name, or nullptr.
const Quantity* known_quantity(std::string_view name);

/// The entry of that name. Throws BadInput by refuse_quantity if there is none.
const Quantity& find_quantity(std::string_view name);

}  // namespace nipref::verify
