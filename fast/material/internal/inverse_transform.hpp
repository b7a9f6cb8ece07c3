#pragma once
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

namespace nipref::fast::internal {

/// 237 bits, so that roots that are one, or nearly so, and parts that cancel cost no digit of a double.
using Wide = boost::multiprecision::cpp_bin_float_oct;

/// Real coefficients, that of p^0 first; the last one is not 0, none: 0.
using Polynomial = std::vector<Wide>;

Polynomial product(const Polynomial& a, const Polynomial& b);
/// What cancels to less than 2^-200 of its parts is 0: leading coefficients of doubles that cancel do so exactly.
Polynomial sum(const Polynomial& a, const Polynomial& b);
Polynomial times(const Wide& factor, Polynomial a);
/// Without the zeros at its end.
Polynomial trimmed(Polynomial a);

/// The numerator over the product of the factors.
struct Rational {
  Polynomial numerator;
  std::vector<Polynomial> denominator;
};

/// A value, and how large the parts are that it is made of.
struct Sized {
  Wide value, size;
};

/// The function of time, t >= 0, with that transform, beside its impulses at 0: divided differences of e^(p t) over
/// the roots of the denominator, which may be any. Good to 2^-150 of the size unless five roots of one factor are one.
Sized inverse_transform(const Rational& transform, double t);

}  // namespace nipref::fast::internal
