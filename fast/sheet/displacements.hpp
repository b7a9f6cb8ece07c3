#pragma once
#include <span>

#include <nipref/data/material/elastic.hpp>
#include <nipref/fast/number/accuracy.hpp>

// Displacements of the surface of an elastic sheet of half-thickness b = 1 under a line load of unit intensity, in plane
// strain; N = theta1 + theta2 = 2 (1 - poisson^2)/young. u is normal to the sheet, v is along it; n stands for a normal
// load, s for a shear load. Arguments, domain and bad input are as in kernels.hpp; a material that is not physical is
// BadInput, too.

namespace nipref::fast {

/// Thesis (4.24), in closed form [theta2 I4(eta) - theta1 I5(eta)]/(pi N), dimensionless. Odd in eta, F1(0) = 0. For
/// eta > 0 it is the thesis's F1, which the thesis multiplies by sign(eta). poisson: dimensionless,
/// -1 < poisson <= 1/2, otherwise BadInput.
double F1(double eta, double poisson, Accuracy accuracy = {});

/// Thesis (4.24): the part of vs that depends on eta, dimensionless. Even, |eta|/4 at infinity. poisson as for F1.
double F2(double eta, double poisson, Accuracy accuracy = {});

/// Thesis (4.8): N I1(alpha)/pi, in 1/stress. Even; alpha = 0: BadInput. The error is that of I1 plus three roundings.
double un(double alpha, const data::ElasticMaterial& material, Accuracy accuracy = {});

/// Thesis (4.8), with the 1/pi that its last bracket lost in print: [N I3(alpha) - theta2 I2(alpha)]/pi + N
/// F1(eta), in 1/stress. Odd in (alpha, eta).
double vn(double alpha, double eta, const data::ElasticMaterial& material, Accuracy accuracy = {});

/// Thesis (4.19a): [theta2 I2(alpha) - N I3(alpha)]/pi, in 1/stress. Odd.
double us(double alpha, const data::ElasticMaterial& material, Accuracy accuracy = {});

/// Thesis (4.19b): [N I6(alpha, eta) + theta1 I7(eta)]/pi, in 1/stress. Even in both; alpha = 0: BadInput.
double vs(double alpha, double eta, const data::ElasticMaterial& material, Accuracy accuracy = {});

/// value[i] = un(alpha[i]), like the batches of kernels.hpp.
void un(std::span<const double> alpha, const data::ElasticMaterial& material, std::span<double> value,
        Accuracy accuracy = {});

}  // namespace nipref::fast
