#include "verify/half_space_corrected.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace nipref::verify {
namespace {

double square(double x) { return x * x; }

/// (c_D/c_S)^2.
double dilatational_speed_squared(double poisson) { return (2 - 2 * poisson) / (1 - 2 * poisson); }

/// The isotropic surface waves' terms over X = speed^2; the differences of near-equal numbers are taken out.
struct IsotropicTerms {
  double shear_root, dilatation_root;  ///< w_S, w_D
  double rayleigh;                     ///< R/X
  double coupling;                     ///< -N/X
  double roots_defect;                 ///< (1 - w_S w_D)/X

  IsotropicTerms(double poisson, double speed) {
    const double x = square(speed);
    const double ratio = 1 / dilatational_speed_squared(poisson);
    shear_root = std::sqrt(1 - x);
    dilatation_root = std::sqrt(1 - x * ratio);
    roots_defect = (1 + ratio - x * ratio) / (1 + shear_root * dilatation_root);
    rayleigh = 4 - x - 4 * roots_defect;
    coupling = 2 * roots_defect - 1;
  }
};

}  // namespace

fast::LineResponse corrected_line_response(const data::IsotropicSolid& solid, double line_speed) {
  const IsotropicTerms terms(solid.poisson, line_speed / std::sqrt(solid.shear / solid.density));
  return {terms.dilatation_root / (solid.shear * terms.rayleigh),
          terms.coupling / (solid.shear * terms.rayleigh)};
}

fast::LineResponse corrected_line_response(const data::TransverselyIsotropicSolid& solid, double line_speed) {
  const double inertia = solid.density * square(line_speed);
  const double a1 = std::sqrt(solid.c11 - inertia);
  const double b5 = std::sqrt(solid.c44 - inertia);
  const double mean = std::sqrt(solid.c33 * solid.c44);
  const double p_plus = std::sqrt(square(std::sqrt(solid.c33) * a1 + std::sqrt(solid.c44) * b5) -
                                  square(solid.c44 + solid.c13));
  const double m =
      a1 * b5 * (b5 + std::sqrt(solid.c33 / solid.c44) * a1) - solid.c44 * a1 - square(solid.c13) * b5 / mean;
  return {a1 * p_plus / (m * mean), (a1 - solid.c13 * b5 / mean) / m};
}

double corrected_in_plane_compliance(const data::TransverselyIsotropicSolid& solid, fast::Direction line,
                                     double line_speed) {
  const double inertia = solid.density * square(line_speed);
  const double cosine2 = square(line.cosine);
  const double sine2 = square(line.sine);
  const double a6 = solid.c44 * sine2 - inertia;
  const double a2 = solid.c33 * sine2 - inertia;
  const double shear_and_c13 = solid.c44 + solid.c13;
  const double trace = solid.c11 * a2 + solid.c44 * a6 - square(shear_and_c13) * sine2;
  const double product = 4 * solid.c11 * solid.c44 * a2 * a6;
  const std::complex<double> difference = std::sqrt(std::complex<double>(square(trace) - product));
  const std::complex<double> b_plus = std::sqrt(cosine2 + (trace + difference) / (2 * solid.c11 * solid.c44));
  const std::complex<double> b_minus =
      std::sqrt(cosine2 + (trace - difference) / (2 * solid.c11 * solid.c44));
  const double b_product = (b_plus * b_minus).real();
  const double b_cubic = b_product * (b_plus + b_minus).real();
  const double b5 = std::sqrt(cosine2 + a6 / solid.c66);
  const double t5 = a6 + 2 * solid.c66 * cosine2;
  const double q =
      square(shear_and_c13) * sine2 / (solid.c11 * solid.c44) - cosine2 - a2 / solid.c44 - b_product;
  const double m = -4 * square(solid.c66) * b5 * b_cubic * cosine2 -
                   solid.c44 * a6 * (cosine2 + a6 / solid.c11 + b_product) * sine2 - q * square(t5) +
                   2 * a6 * t5 * shear_and_c13 * sine2 / solid.c11;
  return a6 * b_cubic / m;
}

fast::LineResponse in_contact(const fast::LineResponse& lower, const fast::LineResponse& upper) {
  return {lower.compliance + upper.compliance, lower.coupling - upper.coupling};
}

double contour_span(const fast::LineResponse& response, double friction_along) {
  const double sheared = friction_along * response.coupling;
  const double omega = -0.5 + std::atan2(sheared, response.compliance) / std::numbers::pi;
  const double q = std::pow(1 + omega, 1 + omega) * std::pow(-omega, -omega);
  return std::hypot(response.compliance, sheared) / q;
}

double exact_span_ratio(const std::function<double(fast::Direction)>& compliance, fast::Direction along,
                        fast::Direction across) {
  constexpr int nodes = 512;
  std::array<double, nodes> k{}, cosine{}, sine{};  // of twice the angle
  for (std::size_t i = 0; i < nodes; ++i) {
    const double angle = (static_cast<double>(i) + 0.5) / nodes * std::numbers::pi;
    k[i] = compliance(fast::Direction::of_angle(angle));
    cosine[i] = std::cos(2 * angle);
    sine[i] = std::sin(2 * angle);
  }
  // w^2 = 1 + a cos 2psi + b sin 2psi but for a factor; the step is Newton's for a circle.
  double a = 0;
  double b = 0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    double whole = 0;
    double along_a = 0;
    double along_b = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double weight = k[i] * std::pow(1 + a * cosine[i] + b * sine[i], -1.5);
      whole += weight;
      along_a += weight * cosine[i];
      along_b += weight * sine[i];
    }
    a += along_a / whole;
    b += along_b / whole;
  }
  const double size = 1 - a * a - b * b;
  // The radius is 1/sqrt(n.A^-1 n), the half-width sqrt(n.A n).
  const auto radius = [&](fast::Direction n) {
    return std::sqrt(size / (1 - a * (square(n.cosine) - square(n.sine)) - 2 * b * n.cosine * n.sine));
  };
  return radius(across) / radius(along);
}

double corrected_rolling_span_ratio(double poisson, double speed) {
  const double d = dilatational_speed_squared(poisson);
  const IsotropicTerms terms(poisson, speed);
  return 0.5 * std::sqrt((d + 1) / (d - 1) * terms.shear_root / terms.dilatation_root * terms.rayleigh /
                         terms.roots_defect);
}

BranchSpeeds corrected_branch_speeds(const data::TransverselyIsotropicSolid& solid, fast::Direction motion) {
  const double cosine2 = square(motion.cosine);
  const double sine2 = square(motion.sine);
  const double p = solid.c11 * cosine2 + solid.c33 * sine2;
  const double p6 = std::sqrt(4 * solid.c44 * p + ((solid.c44 - solid.c11) * (solid.c44 - solid.c33) -
                                                   square(solid.c44 + solid.c13)) *
                                                      4 * cosine2 * sine2);
  const double sum = std::sqrt(solid.c44 + p + p6);
  const double difference = std::sqrt(solid.c44 + p - p6);
  const double per_density = 1 / std::sqrt(solid.density);
  return {std::sqrt(solid.c44 * sine2 + solid.c66 * cosine2) * per_density,
          0.5 * (sum + difference) * per_density, 0.5 * (sum - difference) * per_density};
}

}  // namespace nipref::verify
