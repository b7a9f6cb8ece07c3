#pragma once
#include <string>

#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

namespace nipref::verify {

// The Prony series and the operators of the arguments @rational in quantities.toml.

data::PronySeries prony_of(const NamedPoint& x);
data::DifferentialOperators operators_of(const NamedPoint& x);
ref::ExactSeries exact_series_of(const NamedExact& x, const std::string& function);  ///< theta1 or theta2
ref::ExactRationalSolid exact_prony_of(const NamedExact& x);
ref::ExactRationalSolid exact_operators_of(const NamedExact& x);

/// Sets to its default each number that belongs to a model of the material other than the chosen one.
void default_unread(const NamedNumbers& x);

/// Draws a passive material with relaxation times of the order of `time`. Its rates are equal, nearly equal or far
/// apart, those of operators also complex. Some lack instantaneous deformation, some are fluids. `soft`: 1/modulus.
void draw_prony(const NamedNumbers& x, double soft, double time, Random& random);
void draw_operators(const NamedNumbers& x, double stiff, double time, Random& random);

}  // namespace nipref::verify
