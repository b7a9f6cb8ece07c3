#pragma once
#include <mpfr.h>

#include <utility>

namespace nipref::ref {

/// Owner of one MPFR number. Arithmetic is done through MPFR's own functions on get(), so that every
/// precision and every rounding direction is visible where it is chosen.
class Real {
 public:
  explicit Real(mpfr_prec_t precision) {
    mpfr_init2(value_, precision);
    mpfr_set_zero(value_, 1);
  }
  Real(const Real& other) {
    mpfr_init2(value_, other.precision());
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  Real(Real&& other) noexcept {
    mpfr_init2(value_, MPFR_PREC_MIN);
    mpfr_swap(value_, other.value_);
  }
  Real& operator=(Real other) noexcept {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~Real() { mpfr_clear(value_); }

  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] mpfr_srcptr get() const { return value_; }
  [[nodiscard]] mpfr_prec_t precision() const { return mpfr_get_prec(value_); }

 private:
  mpfr_t value_;
};

}  // namespace nipref::ref
