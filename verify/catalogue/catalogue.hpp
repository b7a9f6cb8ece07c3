#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Every quantity that both paths can compute, in the order in which they are listed. The list is known
/// nowhere else.
const std::vector<Quantity>& catalogue();

/// Throws BadInput that "quantity" is `name`, with the few nearest names of the catalogue and of `groups`,
/// what else could be named there.
[[noreturn]] void refuse_quantity(std::string_view name, const std::vector<std::string_view>& groups = {});

/// The entry of that name, or nullptr.
const Quantity* known_quantity(std::string_view name);

/// The entry of that name; BadInput as refuse_quantity has it if there is none.
const Quantity& find_quantity(std::string_view name);

/// The entries of those names, or the whole catalogue if no name is given. BadInput as above.
std::vector<const Quantity*> select_quantities(const std::vector<std::string>& names);

}  // namespace nipref::verify
