// The stresses inside the sheet by quadrature and Fourier transforms of the tractions: against sums of the proven
// fields of line loads over the contact, a half-plane in closed form, and the resultants.
#include <nipref/ref/nip/internal/inner_field.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/sheet/field.hpp>

#include "support/test.hpp"

using namespace nipref;
using ref::Float;
using ref::FloatStresses;
using ref::InnerField;

namespace {

using Tractions = decltype(nipref::ref::FieldSource::tractions);

double largest_difference(const FloatStresses& a, const FloatStresses& b) {
  return static_cast<double>(
      std::max({abs(a.across - b.across), abs(a.along - b.along), abs(a.shear - b.shear)}));
}

/// Tractions (left right)^(1/2) times polynomials that are neither even nor odd. The total shear is not 0.
ref::PressureAndShear lopsided(const Float& left, const Float& right) {
  const Float root = sqrt(left * right);
  return {root * (1 + left / 3), root * (left - right / 5)};
}

/// The sums of the fields of single loads, by Gauss's rule in the angle: t = -cos(pi x).
struct Summed {
  FloatStresses stresses;
  ref::FloatDisplacements moved;  ///< theta1/N = 7/10

  Summed(const Float& half_length, const Tractions& tractions, double alpha, double depth) {
    const ref::Exact poisson(mpq_class(2, 7)), at(depth), zero(0.0);
    const ref::UnitRule rule = ref::gauss_rule(40);
    for (std::size_t i = 0; i < rule.size(); ++i) {
      const Float angle = ref::pi() * rule.from_left[i], half = sin(angle / 2), other = cos(angle / 2);
      const Float left = 2 * half_length * half * half, right = 2 * half_length * other * other;
      const Float weight = rule.weight[i] * ref::pi() * half_length * sin(angle);
      const ref::PressureAndShear here = tractions(left, right);
      const ref::Exact from = ref::to_exact(alpha + half_length - left);
      for (const auto load : {data::SheetLoad::normal, data::SheetLoad::shear}) {
        const Float force = weight * (load == data::SheetLoad::normal ? here.pressure : here.shear);
        const auto add = [&](Float& sum, const ref::Enclosure& one) {
          sum += force * ref::at_working_precision(one.value);
        };
        add(stresses.across, ref::sheet_across(from, at, load, 20));
        add(stresses.along, ref::sheet_along(from, at, load, 20));
        add(stresses.shear, ref::sheet_shear(from, at, load, 20));
        add(moved.across, ref::sheet_u(from, at, load, poisson, 20));
        add(moved.along, ref::sheet_v(from, zero, at, load, poisson, 20));
      }
    }
  }
};

/// An even pressure and an odd shear.
ref::PressureAndShear symmetric(const Float& left, const Float& right) {
  const Float root = sqrt(left * right);
  return {root, root * (left - right)};
}

}  // namespace

TEST_CASE("inner displacements are those of line loads, and their differences the strains of the stresses") {
  const ref::WorkingDigits working(32);
  const ref::FloatShares exact{Float(7) / 10, Float(3) / 10};
  const auto near = [](const Float& a, const Float& b, double error) {
    CHECK(static_cast<double>(abs(a - b)) < error);
  };
  for (const double half_length : {0.25, 1.0}) {
    const InnerField field({0, half_length, symmetric}, {18, 1, 1});
    for (const double alpha : {0.3, -3.5}) {
      CAPTURE(half_length, alpha);
      const double middle = half_length < 1 ? 0.25 : 0.0;  // far enough from the faces for forty loads
      const ref::FloatDisplacements here = field.displacements({alpha, middle}, exact),
                                    sum = Summed(half_length, symmetric, alpha, middle).moved;
      near(here.across, sum.across, 1e-16);
      near(here.along, sum.along, 1e-16);
      for (const double depth : {0.25, -0.9, 0.99}) {
        CAPTURE(depth);
        const Float step = 1e-6;
        const auto difference = [&](const Float& along, const Float& across) {
          const auto after = field.displacements({alpha + along, depth + across}, exact),
                     before = field.displacements({alpha - along, depth - across}, exact);
          return ref::FloatDisplacements{(after.across - before.across) / (2 * step),
                                         (after.along - before.along) / (2 * step)};
        };
        const ref::FloatDisplacements by_x = difference(0, step), by_y = difference(step, 0);
        const FloatStresses stress = field.at({alpha, depth});
        const Float mean = (exact.theta1 - exact.theta2) / 2 * (stress.across + stress.along);
        near(by_x.across, exact.theta1 * stress.across - mean, 1e-8);
        near(by_y.along, exact.theta1 * stress.along - mean, 1e-8);
        near(by_x.along + by_y.across, 2 * exact.theta1 * stress.shear, 1e-8);
      }
    }
  }
}

TEST_CASE("the inner field is the sum of the proven fields of its line loads, pressure and shear") {
  const ref::WorkingDigits working(32);
  for (const double half_length : {0.25, 1.0}) {
    const InnerField field({0, half_length, lopsided}, {18, 1, 1});
    for (const double alpha : {0.3, -3.5}) {
      // Far enough from the faces for a sum of forty loads.
      const double depth = half_length < 1 ? 0.25 : 0.0;
      CAPTURE(half_length, alpha);
      CHECK(largest_difference(field.at({alpha, depth}),
                               Summed(half_length, lopsided, alpha, depth).stresses) < 1e-16);
      FloatStresses mirrored = field.at({alpha, -depth});
      mirrored.shear = -mirrored.shear;
      CHECK(largest_difference(mirrored, field.at({alpha, depth})) < 1e-17);
    }
  }
}

TEST_CASE("the inner field under a short contact is Hertz's in closed form, from the face to deep") {
  const ref::WorkingDigits working(40);
  const double a = 0x1p-56;  // the load, and with it the effect of the other face, is of this size
  const auto hertz = [&](const Float& left, const Float& right) -> ref::PressureAndShear {
    return {sqrt(left * right) / a, 0};
  };
  const InnerField field({0, a, hertz}, {22, 1, 1});
  // sigma_x + sigma_y = -2 Im F, F = i (Z - sqrt(Z^2 - 1)): Muskhelishvili's function of an elliptic pressure.
  for (const double y : {0.0, 0.5, 0.9999999, 1.25, -0.75}) {
    for (const double d : {0.0, 0x1p-10, 0.75, 4.0}) {
      CAPTURE(y, d);
      using Complex = std::complex<long double>;
      const Complex Z(y, static_cast<long double>(d));
      const Complex root = std::sqrt(Z - 1.0L) * std::sqrt(Z + 1.0L);
      const Complex F = Z - root, slope = 1.0L - Z / root;  // int p/(Z - s) ds over pi, and its derivative
      const long double across = F.imag() - (d == 0 ? 0 : d * slope.real()),
                        along = F.imag() + (d == 0 ? 0 : d * slope.real()),
                        shear = d == 0 ? 0 : d * slope.imag();
      const FloatStresses here = field.at({Float(y) * a, 1 - Float(d) * a});
      CHECK(static_cast<double>(here.across) == doctest::Approx(static_cast<double>(across)).epsilon(1e-14));
      CHECK(static_cast<double>(here.along) == doctest::Approx(static_cast<double>(along)).epsilon(1e-14));
      CHECK(std::fabs(static_cast<double>(here.shear) - static_cast<double>(shear)) < 1e-14);
    }
  }
}

TEST_CASE("inner fields of different fineness and of more digits agree, beside the ends and faces too") {
  const ref::WorkingDigits working(40);
  const InnerField field({0.125, 0.5, lopsided}, {18, 1, 1}), finer({0.125, 0.5, lopsided}, {24, 1.3, 1});
  for (const double alpha : {0.625, 0.62499999999, 0.125, 40.0}) {
    for (const double depth : {1.0, 1 - 1e-13, -0.9999, 0.5, 0.0}) {
      CAPTURE(alpha, depth);
      CHECK(largest_difference(field.at({alpha, depth}), finer.at({alpha, depth})) < 1e-17);
    }
  }
}

TEST_CASE("the inner field has the tractions on a face, and far away is nothing but what the shear pulls") {
  const ref::WorkingDigits working(32);
  const InnerField field({0, 0.5, lopsided}, {18, 1, 1});
  const ref::PressureAndShear there = lopsided(Float(0.75), Float(0.25));
  for (const int face : {1, -1}) {
    const FloatStresses here = field.at({0.25, face});
    CHECK(static_cast<double>(abs(here.across + there.pressure)) < 1e-17);
    CHECK(static_cast<double>(abs(here.shear - face * there.shear)) < 1e-17);
  }
  // The shear force of both faces over both halves of the sheet. Half of it pushes on either side.
  Float force = 0;
  const ref::UnitRule rule = ref::gauss_rule(30);
  for (std::size_t i = 0; i < rule.size(); ++i) {
    const Float angle = ref::pi() * rule.from_left[i], sine = sin(angle / 2), cosine = cos(angle / 2);
    force += rule.weight[i] * ref::pi() / 2 * sin(angle) * lopsided(sine * sine, cosine * cosine).shear;
  }
  for (const int side : {1, -1}) {
    const FloatStresses far = field.at({25 * side, 0.5});
    CHECK(static_cast<double>(abs(far.along + side * force / 2)) < 1e-15);
    CHECK(static_cast<double>(abs(far.across)) < 1e-15);
  }
}
