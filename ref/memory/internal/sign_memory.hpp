#pragma once
#include <nipref/ref/number/exact.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

/// int_0^t e^{-lambda (t - tau)} sign(T - tau) dtau, t > 0, lambda > 0, with an error of e^{-nats} times each of its
/// two parts, before and after T; arguments as in convolutions.hpp.
Interval sign_memory(const mpq_class& lambda, const mpq_class& t, const mpq_class& T, double nats);

}  // namespace nipref::ref
