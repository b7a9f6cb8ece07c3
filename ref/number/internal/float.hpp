#pragma once
#include <mpfr.h>

#include <compare>
#include <concepts>
#include <limits>

#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/real.hpp>

namespace nipref::ref {

/// A number to the working precision of its thread, see WorkingDigits, with the arithmetic of a built-in type:
/// for what is computed in floating point and proven, or estimated, afterwards. A copy is exact; a result is
/// rounded once, to nearest, to the working precision or that of its operands, whatever is more.
class Float {
 public:
  Float();  ///< 0
  Float(double value);
  template <std::integral Integer>
  Float(Integer value) : Float(static_cast<long>(value), Whole()) {}
  Float(const Float& other);
  /// Leaves nothing behind: `other` may only be assigned to or destroyed.
  Float(Float&& other) noexcept { take(other); }
  Float& operator=(const Float& other);
  Float& operator=(Float&& other) noexcept;
  ~Float() {
    if (value_->_mpfr_d != nullptr) mpfr_clear(value_);
  }

  [[nodiscard]] mpfr_ptr get() { return value_; }
  [[nodiscard]] mpfr_srcptr get() const { return value_; }
  explicit operator double() const { return mpfr_get_d(value_, MPFR_RNDN); }
  /// The same, rounded to the working precision.
  [[nodiscard]] Float at_working_precision() const;

  Float& operator+=(const Float& x) { return *this = *this + x; }
  Float& operator-=(const Float& x) { return *this = *this - x; }
  Float& operator*=(const Float& x) { return *this = *this * x; }
  Float& operator/=(const Float& x) { return *this = *this / x; }

  friend Float operator-(const Float& x);
  friend Float operator+(const Float& x, const Float& y);
  friend Float operator-(const Float& x, const Float& y);
  friend Float operator*(const Float& x, const Float& y);
  friend Float operator/(const Float& x, const Float& y);
  friend bool operator==(const Float& x, const Float& y) { return mpfr_equal_p(x.value_, y.value_) != 0; }
  friend std::partial_ordering operator<=>(const Float& x, const Float& y);

 private:
  struct Whole {};
  Float(long value, Whole);
  void take(Float& other) noexcept {
    value_[0] = other.value_[0];
    other.value_->_mpfr_d = nullptr;
  }

  mpfr_t value_;
};

Float abs(const Float& x);
Float sqrt(const Float& x);
Float exp(const Float& x);
Float log(const Float& x);
Float sin(const Float& x);
Float cos(const Float& x);
Float acos(const Float& x);
Float atan(const Float& x);
Float sinh(const Float& x);
Float cosh(const Float& x);
Float asinh(const Float& x);
Float atanh(const Float& x);
Float hypot(const Float& x, const Float& y);
Float pow(const Float& x, const Float& y);
/// x 2^exponent
Float ldexp(const Float& x, long exponent);
Float pi();

/// While it lives, new numbers of this thread have this many decimal digits; 50 without one.
class WorkingDigits {
 public:
  explicit WorkingDigits(int digits);
  WorkingDigits(const WorkingDigits&) = delete;
  WorkingDigits& operator=(const WorkingDigits&) = delete;
  ~WorkingDigits();

 private:
  mpfr_prec_t before_;
};

/// Rounded to the working precision.
Float to_float(const Real& real);
Float to_float(const Exact& exact);
/// Exactly.
Real to_real(const Float& value);
Exact to_exact(const Float& value);

}  // namespace nipref::ref

/// Of the working precision.
template <>
struct std::numeric_limits<nipref::ref::Float> {
  static constexpr bool is_specialized = true;
  /// 2 to the power 1 - bits.
  static nipref::ref::Float epsilon();
  /// The smallest positive number.
  static nipref::ref::Float min();
};
