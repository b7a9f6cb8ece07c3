#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// Every quantity that both paths can compute, in the order in which they are listed. The list is known
/// nowhere else.
const std::vector<Quantity>& catalogue();

/// Their names, with commas between them.
std::string quantity_names();

/// The entry of that name; BadInput naming "quantity" and all known names if there is none.
const Quantity& find_quantity(std::string_view name);

/// The entries of those names, or the whole catalogue if no name is given. BadInput as above.
std::vector<const Quantity*> select_quantities(const std::vector<std::string>& names);

}  // namespace nipref::verify
