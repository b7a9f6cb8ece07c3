#include <cmath>
#include <numbers>

#include <nipref/fast/sheet/displacements.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>
#include <nipref/fast/sheet/internal/theta_shares.hpp>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

using internal::shares_of;
using std::numbers::inv_pi;

/// Checks with a Young's modulus of 1, as theta1/N and theta2/N do not depend on it.
void check_poisson(double poisson) { data::ElasticMaterial{1, poisson}.check(); }

double normal_step(double alpha, const data::ElasticMaterial& material, Accuracy accuracy) {
  return (material.normal_compliance() * I3(alpha, accuracy) - material.theta2() * I2(alpha)) * inv_pi;
}

double F1_of_checked(double eta, double poisson, Accuracy accuracy) {
  const auto [theta1, theta2] = shares_of(poisson);
  return (theta2 * I4(eta, accuracy) - theta1 * I5(eta, accuracy)) * inv_pi;
}

}  // namespace

double F1(double eta, double poisson, Accuracy accuracy) {
  check_poisson(poisson);
  return F1_of_checked(eta, poisson, accuracy);
}

double F2(double eta, double poisson, Accuracy accuracy) {
  check_poisson(poisson);
  const double i7 = I7(eta, accuracy);
  const int part = static_cast<int>(internal::Component::eta_part_of_I6);
  const double s = internal::sheet_code().scalar[part][accuracy.tier()](eta);
  return std::fabs(eta) / 4 + (shares_of(poisson).theta1 * i7 - s) * inv_pi;
}

double un(double alpha, const data::ElasticMaterial& material, Accuracy accuracy) {
  material.check();
  return material.normal_compliance() * inv_pi * I1(alpha, accuracy);
}

double vn(double alpha, double eta, const data::ElasticMaterial& material, Accuracy accuracy) {
  material.check();
  return normal_step(alpha, material, accuracy) +
         material.normal_compliance() * F1_of_checked(eta, material.poisson, accuracy);
}

double us(double alpha, const data::ElasticMaterial& material, Accuracy accuracy) {
  material.check();
  return -normal_step(alpha, material, accuracy);
}

double vs(double alpha, double eta, const data::ElasticMaterial& material, Accuracy accuracy) {
  material.check();
  return (material.normal_compliance() * I6(alpha, eta, accuracy) + material.theta1() * I7(eta, accuracy)) *
         inv_pi;
}

void un(std::span<const double> alpha, const data::ElasticMaterial& material, std::span<double> value,
        Accuracy accuracy) {
  material.check();
  I1(alpha, value, accuracy);
  const double factor = material.normal_compliance() * inv_pi;
  for (double& displacement : value) displacement *= factor;
}

}  // namespace nipref::fast
