#include <utility>

#include <nipref/ref/number/estimated.hpp>
#include <nipref/ref/number/internal/decimal_text.hpp>

namespace nipref::ref {

Estimated::Estimated(Real the_value, Real the_error, int the_digits)
    : value(std::move(the_value)), error(std::move(the_error)), digits(the_digits) {}

Estimated::Estimated(const Enclosure& enclosure)
    : Estimated(enclosure.value, enclosure.error_bound, enclosure.digits) {}

std::string Estimated::value_text() const { return decimal_text(value, digits); }
std::string Estimated::error_text() const { return ref::error_text(value, error, digits); }
double Estimated::to_double() const { return mpfr_get_d(value.get(), MPFR_RNDN); }
double Estimated::error_of(double x) const { return ref::error_of(x, value); }

}  // namespace nipref::ref
