#pragma once
#include <array>

#include <nipref/fast/memory/internal/waves.hpp>
#include <nipref/fast/number/accuracy.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::internal {

/// Up to this distance from the load the logarithm of I1 is treated apart, as in the table of the smooth rest.
constexpr double inner_end = near_end;

inline constexpr int most_nodes = 32;
using Nodes = std::array<double, most_nodes>;

/// int_0^length e^(-rate d) f(d) dd from the values of f at the rule's points.
double faded_sum(const GaussRule& rule, const Nodes& values, double length, double rate);
Complex faded_sum(const GaussRule& rule, const Nodes& values, double length, Complex rate);

/// The rule for e^(-decays s) on [0, 1] times a function as smooth as the regular part of I1 on [0, 1/2].
const GaussRule& gauss_rule_for(double decays, Accuracy accuracy);

/// int_0^length e^(-rate d) I(v + step d) dd by one Gauss rule, where v and v + step length are distances from the
/// load >= 0, and step is 1 ahead of the load, -1 behind it. For I1 their ratio must be below 6.
template <typename Rate>
Rate by_rule(Kernel kernel, double v, int step, double length, Rate rate, Accuracy accuracy);

}  // namespace nipref::fast::internal
