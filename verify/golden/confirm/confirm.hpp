#pragma once
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include <nipref/ref/number/real.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

/// What a second method says of a quantity at a point. Neither the code that makes the value nor its arithmetic is in
/// it: numbers are Boost's over MPFR and MPC.
struct Confirmation {
  std::string method;
  ref::Real value;
  ref::Real error;  ///< estimate: what the method changes by when its own work is halved
};

using Confirm = std::function<Confirmation(std::span<const double> point)>;

/// Second methods by the names of their quantities.
using Methods = std::map<std::string, Confirm, std::less<>>;

/// The one for the quantity of that name; empty if it is not among them.
Confirm found_in(const Methods& methods, std::string_view quantity);

/// The second method for the quantity of that name; empty if there is none.
Confirm confirmer_of(std::string_view quantity);

}  // namespace nipref::verify
