#pragma once
#include <concepts>
#include <optional>
#include <span>
#include <string>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The errors of another implementation of a quantity, measured like those of fast.
struct Grade {
  std::string what;   ///< what was graded, in words: a file, a kernel of a shared object
  std::string where;  ///< the given ranges of arguments, or "its domain"
  AuditResult found;
  std::optional<double> condition;  ///< of the quantity at the worst point, dimensionless
  std::string worst_value;          ///< the reference's value there, 21 digits
};

/// The condition number of the quantity at the point, dimensionless: the sum of |x df/dx| / |f| over its numerical
/// arguments x. An error of one unit in the last place of each argument changes the value by about so many units in
/// the last place. It follows from difference quotients of the reference with relative steps of 2^-20, to a relative
/// accuracy of about 1e-10 where the quantity is smooth. Nothing if the value is 0 or the reference refuses a
/// neighbouring point.
std::optional<double> condition_number(const Quantity& quantity, const Point& point);

/// Adds the reference's value and the condition number at the worst point.
Grade grade_of(std::string what, std::string where, AuditResult found);

/// Grades a callable: double(double) for a quantity of one argument, or double(std::span<const double> arguments). It
/// is called from several threads at once. Everything else is as in audit().
template <class Callable>
Grade grade(const Quantity& quantity, const Callable& callable, const AuditOptions& options) {
  const auto one_by_one = [&](std::span<const Point> points, std::span<double> values) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if constexpr (std::invocable<Callable, double>) {
        values[i] = callable(points[i].front());
      } else {
        values[i] = callable(std::span<const double>(points[i]));
      }
    }
  };
  return grade_of("a callable", "its domain", audit(quantity, one_by_one, options));
}

Json grade_json(const Grade& grade);

}  // namespace nipref::verify
