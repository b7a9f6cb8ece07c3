#pragma once
#include <mpfi.h>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/float.hpp>

namespace nipref::ref {

/// Owner of one MPFI interval. Every operation returns an interval that contains the true result for all
/// points of its operands; its precision is that of the widest operand.
class Interval {
 public:
  explicit Interval(mpfr_prec_t precision) {
    mpfi_init2(value_, precision);
    mpfi_set_si(value_, 0);
  }
  Interval(long value, mpfr_prec_t precision) : Interval(precision) { mpfi_set_si(value_, value); }
  Interval(double value, mpfr_prec_t precision) : Interval(precision) { mpfi_set_d(value_, value); }
  Interval(const mpq_class& value, mpfr_prec_t precision) : Interval(precision) {
    mpfi_set_q(value_, value.get_mpq_t());
  }
  Interval(const Exact& value, mpfr_prec_t precision) : Interval(value.value(), precision) {}
  /// [lower, upper], rounded outwards.
  Interval(const Float& lower, const Float& upper, mpfr_prec_t precision) : Interval(precision) {
    mpfi_interv_fr(value_, raw(lower), raw(upper));
  }
  Interval(const Interval& other) : Interval(other.precision()) { mpfi_set(value_, other.value_); }
  Interval(Interval&& other) noexcept {
    mpfi_init2(value_, MPFR_PREC_MIN);
    mpfi_swap(value_, other.value_);
  }
  Interval& operator=(Interval other) noexcept {
    mpfi_swap(value_, other.value_);
    return *this;
  }
  ~Interval() { mpfi_clear(value_); }

  static Interval pi(mpfr_prec_t precision) {
    Interval result(precision);
    mpfi_const_pi(result.value_);
    return result;
  }

  [[nodiscard]] mpfi_ptr get() { return value_; }
  [[nodiscard]] mpfi_srcptr get() const { return value_; }
  [[nodiscard]] mpfr_prec_t precision() const { return mpfi_get_prec(value_); }
  [[nodiscard]] mpfr_srcptr lower() const { return &value_->left; }
  [[nodiscard]] mpfr_srcptr upper() const { return &value_->right; }

  /// The interval made wider by `radius` >= 0 on both sides (its upper end counts).
  [[nodiscard]] Interval widened(const Interval& radius) const;

 private:
  mpfi_t value_;
};

/// 1 or -1 if all numbers of the interval have that sign, otherwise 0.
int sign_of(const Interval& x);

Interval operator-(const Interval& x);
Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
Interval operator/(const Interval& x, const Interval& y);
Interval operator+(const Interval& x, long y);
Interval operator-(const Interval& x, long y);
Interval operator-(long x, const Interval& y);
Interval operator*(long x, const Interval& y);
Interval operator/(const Interval& x, long y);
Interval operator/(long x, const Interval& y);
Interval abs(const Interval& x);
Interval exp(const Interval& x);
Interval expm1(const Interval& x);
Interval log(const Interval& x);
Interval log1p(const Interval& x);
Interval sqrt(const Interval& x);
Interval square(const Interval& x);
Interval cosh(const Interval& x);
Interval sinh(const Interval& x);
Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval acos(const Interval& x);
Interval atan(const Interval& x);

}  // namespace nipref::ref
