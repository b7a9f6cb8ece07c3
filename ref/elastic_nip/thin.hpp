#pragma once
#include <nipref/data/problem/elastic_nip.hpp>
#include <nipref/ref/number/estimate.hpp>

namespace nipref::ref {

/// Numbers of the frictionless contact of an elastic nip that is so long that its ends do not feel each other.
///
/// Between the ends the pressure is the parabola's own plus waves that have fallen like e^(-pi x), x half-thicknesses
/// from an end, the zeros of I1's symbol, and twice that far at the other end: so load, indentation and mean strain are
/// polynomials of L/B up to terms like e^(-2 pi L/B). They are known where shorter contacts are, by
/// ConvergedElasticNip with its bounds. The error is what the bounds make of the polynomial's value, and what that
/// changes by when its leading coefficient, which is a spring's, is taken as known: an estimate, for the terms left out
/// are not bounded. The middle, half as far from the ends, has the pressure 4 d0/(N B) of springs up to terms like
/// e^(-pi L/B), which are in its error. Units as in data::ElasticNip. (thesis 5.3, thin sheets)
struct LongContactFit {
  Estimate load;           ///< W, force per unit width
  Estimate indentation;    ///< d0, unit of length
  Estimate creep_ratio;    ///< (2/L) v(L/2)
  Estimate peak_pressure;  ///< unit of stress
};

/// L/B from which on `digits` come so: 10 for up to 21.
double shortest_thin_nip(int digits);

/// Contact of the given length, L/B from shortest_thin_nip(digits) to 1e4 and L <= R; digits 16 to 80. BadInput
/// otherwise.
LongContactFit thin_nip_of_length(const data::ElasticNip& nip, double contact_length, int digits);

}  // namespace nipref::ref
