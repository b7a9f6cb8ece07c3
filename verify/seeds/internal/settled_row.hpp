#pragma once
#include <cmath>
#include <string>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/seeds/errata.hpp>

namespace nipref::verify {

/// A quantity at decimal arguments, by both paths.
struct SettledRow {
  const Quantity* quantity;
  Point point;         ///< the doubles nearest to the arguments
  Propagated by_fast;  ///< its promise at that point, and what it changes from the decimals to the doubles
  Propagated by_ref;

  static Propagated in_double(const ref::Estimate& reference);

  /// BadInput for what the command line would refuse.
  SettledRow(const std::string& name, const Assignments& given);
};

/// The value of a printed formula as the catalogue has it, in double arithmetic that nothing bounds: it is stated to
/// eight digits of the sixteen, enough to tell it from the truth.
inline Propagated printed_form(double value) { return {value, 1e-8 * std::fabs(value)}; }

/// A catalogue's quantity with its printed form: fast has the right one, ref the truth.
Settlement settled_by_form(const std::string& name, const Assignments& given);

}  // namespace nipref::verify
