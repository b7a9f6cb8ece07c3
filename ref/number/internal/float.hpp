#pragma once
#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>
#include <boost/multiprecision/mpfr.hpp>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/real.hpp>

// Linear algebra in multiprecision: Eigen over Boost's MPFR type. Heavy to compile; for .cpp files of this
// room only.

namespace nipref::ref {

using Float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                            boost::multiprecision::et_off>;
using Matrix = Eigen::Matrix<Float, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Float, Eigen::Dynamic, 1>;

/// While it lives, new numbers of this thread have this many decimal digits.
class WorkingDigits {
 public:
  explicit WorkingDigits(int digits) : before_(Float::thread_default_precision()) {
    Float::thread_default_precision(static_cast<unsigned>(digits));
  }
  WorkingDigits(const WorkingDigits&) = delete;
  WorkingDigits& operator=(const WorkingDigits&) = delete;
  ~WorkingDigits() { Float::thread_default_precision(before_); }

 private:
  unsigned before_;
};

inline Float to_float(const Real& real) {
  Float value;
  mpfr_set(value.backend().data(), real.get(), MPFR_RNDN);
  return value;
}

inline Real to_real(const Float& value) {
  Real real(mpfr_get_prec(value.backend().data()));
  mpfr_set(real.get(), value.backend().data(), MPFR_RNDN);
  return real;
}

/// The decimal text of the value as an exact argument of a kernel: equal to it to the working digits.
inline Exact to_exact(const Float& value) { return Exact::parse(value.str(0, std::ios_base::scientific)); }

}  // namespace nipref::ref
