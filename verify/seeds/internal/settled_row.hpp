#pragma once
#include <string>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/seeds/errata.hpp>

namespace nipref::verify {

/// A quantity at arguments, by both paths.
struct SettledRow {
  const Quantity* quantity;
  Point point;
  double by_fast, by_ref;
  double promised;  ///< how far they may be apart

  /// BadInput for what the command line would refuse.
  SettledRow(const std::string& name, const Assignments& given);
};

/// A catalogue's quantity with its printed form: fast has the right one, ref the truth.
Settlement settled_by_form(const std::string& name, const Assignments& given);

}  // namespace nipref::verify
