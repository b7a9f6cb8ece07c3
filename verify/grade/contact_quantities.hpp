#pragma once
#include <string>
#include <vector>

#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// The results of a kind of golden contacts, KIND.RESULT, as quantities of the keys that the kind's sweep varies, with
/// lists among them as choices. The reference solves a contact once for all of them, to contact_digits, and errors are
/// measured as the scene's results are. They live as long as the program. BadInput if there is no such kind.
const std::vector<Quantity>& contact_quantities(const std::string& kind);

/// The contacts of all combinations as points of these quantities. BadInput for a key that does not vary, and for a list
/// that is none of the choices.
std::vector<Point> contact_points(const std::string& kind, const AxesProduct& contacts);

}  // namespace nipref::verify
