#include <utility>

#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {

Estimate::Estimate(Real the_value, Real the_error, int the_digits)
    : WithError{std::move(the_value), std::move(the_error)}, digits(the_digits) {}

std::string Estimate::value_text() const { return decimal_text(value, digits); }
std::string Estimate::error_text() const { return ref::error_text(value, error, digits); }
double Estimate::to_double() const { return mpfr_get_d(value.get(), MPFR_RNDN); }
double Estimate::error_of(double x) const { return ref::error_of(x, value); }

}  // namespace nipref::ref
