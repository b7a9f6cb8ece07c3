#pragma once
#include <boost/multiprecision/mpc.hpp>
#include <boost/multiprecision/mpfr.hpp>
#include <string>
#include <vector>

#include <nipref/ref/number/exact.hpp>

/// Numbers for independent computations, which share only MPFR with the arithmetic of the reference path.
namespace nipref::test {

template <unsigned digits>
using Decimal = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<digits>,
                                              boost::multiprecision::et_off>;
template <unsigned digits>
using ComplexDecimal = boost::multiprecision::number<boost::multiprecision::mpc_complex_backend<digits>,
                                                     boost::multiprecision::et_off>;

inline ref::Exact exact(const std::string& text) { return ref::Exact::parse(text); }

inline std::vector<ref::Exact> exacts(const std::vector<std::string>& texts) {
  std::vector<ref::Exact> numbers;
  for (const std::string& text : texts) numbers.push_back(exact(text));
  return numbers;
}

template <unsigned digits>
ref::Exact exact(const Decimal<digits>& x) {
  return exact(x.str(digits, std::ios_base::scientific));
}

}  // namespace nipref::test
