#include <cmath>

#include <nipref/fast/half_space/internal/transversely_isotropic_line.hpp>
#include <nipref/fast/number/internal/bisection.hpp>
#include <nipref/fast/number/internal/instruction_level.hpp>

// The code is compiled a second time for processors with a fused multiply-add, with which a product of two words takes
// fewer instructions.
#ifdef NIPREF_X86_LEVELS
#define NIPREF_FUSED [[gnu::target("arch=x86-64-v3")]]
#else
#define NIPREF_FUSED
#endif
#define NIPREF_TWICE [[gnu::always_inline]] inline

namespace nipref::fast::internal {
namespace {

constexpr Two one{1};

double power_of_two(double modulus) { return std::scalbn(1.0, std::ilogb(modulus)); }

data::TransverselyIsotropicSolid times(double factor, const data::TransverselyIsotropicSolid& solid) {
  return {solid.c11 * factor, solid.c33 * factor, solid.c13 * factor,
          solid.c44 * factor, solid.c66 * factor, solid.density};
}

std::variant<NormalAxisLine, InPlaneAxisLine> line_of(const data::TransverselyIsotropicSolid& solid,
                                                      data::SymmetryAxis axis) {
  if (axis == data::SymmetryAxis::normal) return NormalAxisLine(solid);
  return InPlaneAxisLine(solid);
}

}  // namespace

NormalAxisLine::NormalAxisLine(const data::TransverselyIsotropicSolid& solid)
    : d1_(solid.c11),
      d3_(solid.c33),
      d5_(solid.c44),
      d13_(solid.c13),
      determinant_(two_product(d1_, d3_) - two_product(d13_, d13_)),
      sum_(two_sum(d5_, d13_)),
      root3_(sqrt(Two{d3_})),
      root5_(sqrt(Two{d5_})) {
  if (sum_.high < 0) sum_ = -sum_;
}

double NormalAxisLine::bound(Direction) const { return d5_; }

NIPREF_TWICE LineFunctions NormalAxisLine::at(Direction psi, Two scaled_X) const {
  const Two X = scaled_X / squared_length(psi);
  const Two A1_squared = Two{d1_} - X, B5_squared = Two{d5_} - X;
  if (!(A1_squared.high > 0 && B5_squared.high > 0)) return {};
  const Two A1 = sqrt(A1_squared), B5 = sqrt(B5_squared);
  const Two roots = root3_ * A1 + root5_ * B5;
  const Two P_squared = (roots - sum_) * (roots + sum_);  // P_+^2
  if (!(P_squared.high > 0)) return {};
  // sqrt(d3 d5) M without its factor d5 - B5^2 = X
  const Two stiff = root3_ * root5_ * A1;
  const Two rayleigh = B5 * (determinant_ - d3_ * X) - X * stiff;
  return {rayleigh, A1 * sqrt(P_squared), stiff - d13_ * B5};
}

InPlaneAxisLine::InPlaneAxisLine(const data::TransverselyIsotropicSolid& solid)
    : d2_(solid.c33),
      d5_(solid.c66),
      d6_(solid.c44),
      inverse1_(one / Two{solid.c11}),
      inverse5_(one / Two{d5_}),
      inverse6_(one / Two{d6_}) {
  const Two sum = two_sum(d6_, solid.c13);
  sum_over_d1_ = sum * inverse1_;
  coupling_ = sum * sum_over_d1_ * inverse6_;
}

double InPlaneAxisLine::bound(Direction psi) const {
  return d5_ * psi.cosine * psi.cosine + d6_ * psi.sine * psi.sine;
}

// With Pi = B+ B- and Sigma = B+ + B-, which are real where B+- are conjugate:
//   Pi^2 = B1^2 B2^2 - e cos^2,  Sigma^2 = 2 Pi + B1^2 + h,  B2^2 = cos^2 + A2/d6,
//   e = (d6 + d12)^2 sin^2/(d1 d6),  h = B2^2 - e,  q = -Q_B = Pi + h.
// The determinant M of the paper and the numerators all have the factor A6, because
//   B5 Pi Sigma - q cos^2 = A6 G,
//   (B5 Pi Sigma)^2 - (q cos^2)^2 = A6 [Pi^2 Sigma^2/d5 + cos^2 ((2 Pi + h) B2^2 + Pi^2)/d1].
// Without this factor, the third row of the inverse impedance is
//   M/A6 = 2 d5 B5 Pi Sigma + T5 J1 - d6 sin^2 J2,  (Pi Sigma, cos J1, -sin J2)/(M/A6),
//   J1 = q - 2 d5 G + (d6 + d12) sin^2/d1,  J2 = Pi + B1^2 - (d6 + d12) T5/(d1 d6).
NIPREF_TWICE LineFunctions InPlaneAxisLine::at(Direction psi, Two X) const {
  const Two cos2 = square(cosine_of(psi)), sin2 = square(sine_of(psi));
  const Two A6 = d6_ * sin2 - X, A2 = d2_ * sin2 - X;
  const Two B1_squared = cos2 + A6 * inverse1_, B2_squared = cos2 + A2 * inverse6_,
            B5_squared = cos2 + A6 * inverse5_;
  if (!(B1_squared.high > 0 && B2_squared.high > 0 && B5_squared.high > 0)) return {};
  const Two e = coupling_ * sin2, h = B2_squared - e;
  const Two Pi_squared = B1_squared * B2_squared - e * cos2;
  if (!(Pi_squared.high > 0)) return {};
  const Two Pi = sqrt(Pi_squared);
  const Two Sigma_squared = twice(Pi) + B1_squared + h;
  if (!(Sigma_squared.high > 0)) return {};
  const Two compliance = Pi * sqrt(Sigma_squared);

  const Two q = Pi + h, left = sqrt(B5_squared) * compliance, right = q * cos2;
  // A6 = 0 needs q > 0; for q < 0 nothing cancels in the difference itself.
  const Two G = q.high > 0 ? (Pi_squared * Sigma_squared * inverse5_ +
                              cos2 * inverse1_ * ((Pi + q) * B2_squared + Pi_squared)) /
                                 (left + right)
                           : (left - right) / A6;
  const Two T5 = A6 + (2 * d5_) * cos2;
  const Two J1 = q - (2 * d5_) * G + sum_over_d1_ * sin2;
  const Two J2 = Pi + B1_squared - sum_over_d1_ * inverse6_ * T5;
  const Two rayleigh = (2 * d5_) * left + T5 * J1 - d6_ * sin2 * J2;
  return {rayleigh, compliance, sin2 * J2 - cos2 * J1, psi.cosine * psi.sine * (J1 + J2).high};
}

TransverselyIsotropicLine::TransverselyIsotropicLine(const data::TransverselyIsotropicSolid& solid,
                                                     data::SymmetryAxis axis)
    : inverse_unit_(1 / power_of_two(solid.c44)),
      density_(solid.density * inverse_unit_),
      line_(line_of(times(inverse_unit_, solid), axis)) {}

namespace {

template <class Line>
NIPREF_FUSED LineFunctions fused(const Line& line, Direction psi, Two X) {
  return line.at(psi, X);
}

}  // namespace

LineFunctions TransverselyIsotropicLine::functions(Direction psi, Two X) const {
  const auto of = [&](const auto& line) {
    return chosen_instruction_set > 0 ? fused(line, psi, X) : line.at(psi, X);
  };
  return std::visit(of, line_);
}

bool TransverselyIsotropicLine::is_subcritical(Direction psi, Two speed) const {
  return functions(psi, density_ * square(speed)).subcritical();
}

// Numerators and denominators have two words, as their terms cancel; double suffices for their quotients.
std::optional<LineResponse> TransverselyIsotropicLine::at(Direction psi, const Motion& motion) const {
  const LineFunctions line = functions(psi, stress_density(density_, psi, motion));
  if (!line.subcritical()) return std::nullopt;
  const double divisor = line.rayleigh.high;
  return LineResponse{line.compliance.high / divisor * inverse_unit_,
                      line.coupling.high / divisor * inverse_unit_,
                      line.coupling_across / divisor * inverse_unit_};
}

// Uses a central difference in two words. With this step the rounding error is 1e-13 of the result, and the truncation
// error is (step/gap)^2, where `gap` is the relative distance from the critical speed.
double TransverselyIsotropicLine::condition(Direction psi, const Motion& motion) const {
  constexpr double step = 0x1p-50;
  const Two X = stress_density(density_, psi, motion);
  const auto compliance = [&](double change) {
    const LineFunctions line = functions(psi, X + change * X);
    return line.compliance / line.rayleigh;
  };
  const Two above = compliance(step), below = compliance(-step);
  return 2 * (above - below).high / (above + below).high / step;
}

double TransverselyIsotropicLine::limit(Direction psi) const {
  const double bound = std::visit([&](const auto& line) { return line.bound(psi); }, line_);
  const double beyond = 1.001 * std::sqrt(bound / density_);
  return last_that([&](double speed) { return is_subcritical(psi, {speed}); }, 0, beyond);
}

Two TransverselyIsotropicLine::limit_in_two_words(Direction psi) const {
  return last_in_two_words([&](Two speed) { return is_subcritical(psi, speed); }, limit(psi));
}

}  // namespace nipref::fast::internal
