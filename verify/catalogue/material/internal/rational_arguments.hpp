#pragma once
#include <span>
#include <string>
#include <vector>

#include <nipref/fast/material/rational_solid.hpp>
#include <nipref/ref/material/rational_solid.hpp>
#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

// Arguments by which rows take a Prony series of up to two terms and operators of up to second order: theta1_instantaneous,
// theta1_amplitude, theta1_rate, theta1_amplitude_2, theta1_rate_2, theta2_... likewise; P_0 P_1 P_2, Q_.., P_dilatation_..,
// Q_dilatation_... An amplitude of 0 leaves its term out, a highest coefficient of 0 its power. Defaults: a standard
// linear solid whose compliances double in a unit of time.

inline constexpr std::size_t prony_arguments = 10, operator_arguments = 12;

void append_prony_arguments(std::vector<Argument>& arguments);
void append_operator_arguments(std::vector<Argument>& arguments);

data::PronySeries prony_of(std::span<const double> x);
data::DifferentialOperators operators_of(std::span<const double> x);
ref::ExactRationalSolid exact_prony_of(std::span<const ref::Exact> x);
ref::ExactRationalSolid exact_operators_of(std::span<const ref::Exact> x);

/// Keys of the models "prony" and "operators", as in a scene.
std::vector<ModelKey> prony_keys();
std::vector<ModelKey> operator_keys();
/// Keys of the same name as the argument that holds their number.
std::vector<ModelKey> keys_of_numbers(const std::vector<std::string>& arguments);

/// Sets to its default each number of `x` that belongs to a model of the material other than the chosen one.
void default_unread(std::span<double> x, const std::vector<Argument>& arguments);

/// What loses energy and has times about `time`: rates equal, nearly so and far apart, in operators complex too, now and
/// then nothing at once or a fluid. `soft`: 1/modulus.
void draw_prony(Point& x, double soft, double time, Random& random);
void draw_operators(Point& x, double stiff, double time, Random& random);

}  // namespace nipref::verify
