#pragma once
#include <span>
#include <string>
#include <vector>

#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

namespace nipref::verify {

// Arguments by which quantities take a Prony series of up to two terms and operators of up to second order:
// theta1_instantaneous, theta1_amplitude, theta1_rate, theta1_amplitude_2, theta1_rate_2, theta2_... likewise; P_0 P_1 P_2,
// Q_.., P_dilatation_.., Q_dilatation_... An amplitude of 0 leaves its term out, a highest coefficient of 0 its power.
// Defaults: a standard linear solid whose compliances double in a unit of time.

/// The arguments of both.
std::vector<Argument> rational_arguments();
std::vector<Argument> operator_arguments();

data::PronySeries prony_of(const NamedPoint& x);
data::DifferentialOperators operators_of(const NamedPoint& x);
ref::ExactSeries exact_series_of(const NamedExact& x, const std::string& function);  ///< theta1 or theta2
ref::ExactRationalSolid exact_prony_of(const NamedExact& x);
ref::ExactRationalSolid exact_operators_of(const NamedExact& x);

/// Keys of the models "prony" and "operators", as in a scene.
std::vector<ModelKey> prony_keys();
std::vector<ModelKey> operator_keys();

/// Sets to its default each number that belongs to a model of the material other than the chosen one.
void default_unread(const NamedNumbers& x);

/// Draws what loses energy and has times about `time`: rates equal, nearly so and far apart, in operators complex too, now
/// and then nothing at once or a fluid. `soft`: 1/modulus.
void draw_prony(const NamedNumbers& x, double soft, double time, Random& random);
void draw_operators(const NamedNumbers& x, double stiff, double time, Random& random);

}  // namespace nipref::verify
