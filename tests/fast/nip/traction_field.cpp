#include <nipref/data/material/elastic.hpp>
#include <nipref/fast/nip/internal/traction_field.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;

namespace {

/// Hertz's ellipse of pressure; with a shear that swings at the ends as that of full friction does.
FaceTractions ellipse(double half_length, double friction) {
  return [=](bool right, double e) -> FaceTraction {
    const double pressure = std::sqrt(e * (2 * half_length - e)) / half_length, y = half_length - e;
    const double swing = e > 0 ? std::cos(0.17 * std::log(e)) : 0;
    return {pressure, (right ? 1 : -1) * friction * pressure * y / half_length * swing};
  };
}

/// Visits the tractions as line loads, e = A x^4: the load, its size and its distance before the point.
template <class Visit>
void for_line_loads(double half_length, const FaceTractions& traction, double alpha, const Visit& visit) {
  const GaussRule rule = gauss_legendre(300);
  for (const bool right : {false, true}) {
    for (std::size_t j = 0; j < rule.at.size(); ++j) {
      const double x = rule.at[j], e = half_length * x * x * x * x;
      const double weight = 4 * half_length * x * x * x * rule.weight[j];
      const double from = alpha - (right ? half_length - e : e - half_length);
      const FaceTraction here = traction(right, e);
      visit(data::SheetLoad::normal, weight * here.pressure, from);
      visit(data::SheetLoad::shear, weight * here.shear, from);
    }
  }
}

/// For places that are not near the face.
SheetStresses by_line_loads(double half_length, const FaceTractions& traction, const SheetPoint& at) {
  SheetStresses sum{};
  for_line_loads(half_length, traction, at.alpha, [&](data::SheetLoad load, double size, double from) {
    const SheetStresses one = sheet_stresses(from, at.depth, load);
    sum.across += size * one.across;
    sum.along += size * one.along;
    sum.shear += size * one.shear;
  });
  return sum;
}

double distance(const SheetStresses& a, const SheetStresses& b) {
  return std::max(
      {std::fabs(a.across - b.across), std::fabs(a.along - b.along), std::fabs(a.shear - b.shear)});
}

}  // namespace

TEST_CASE("the field is the sum of those of line loads, to its rounding") {
  for (const double half_length : {1e-3, 0.3, 1.0, 4.0}) {
    CAPTURE(half_length);
    // The second swings as a contact with a memory that does.
    const auto smooth = ellipse(half_length, 0.3);
    const FaceTractions swinging = [&](bool right, double e) -> FaceTraction {
      const FaceTraction here = smooth(right, e);
      return {here.pressure * (1 + 0.3 * std::sin((right ? 90 : 70) * e / half_length)), here.shear};
    };
    for (const FaceTractions& traction : {smooth, swinging}) {
      const TractionField field(half_length, false, traction);
      CHECK(field.unresolved() < 1e-14);
      for (const double depth : {0.0, -0.4, 1 - std::min(0.1 * half_length, 0.5)}) {
        for (const double share : {0.0, 0.37, -1.1}) {
          const SheetPoint at{share * half_length, depth};
          const double rounding_of_loads = 8e-15;
          CHECK(distance(field.at(at), by_line_loads(half_length, traction, at)) <
                field.rounding() + field.unresolved() + rounding_of_loads);
        }
      }
    }
  }
}

TEST_CASE("displacements from the face differ between depths as those of line loads do, near and far") {
  const data::ElasticMaterial material{1, 0.3};
  const double theta1 = 1 / (2 * (1 - material.poisson));
  const internal::Shares share{theta1, 1 - theta1};
  for (const double half_length : {0.01, 0.7, 12.5}) {
    const FaceTractions traction = ellipse(half_length, 0.4);
    const TractionField field(half_length, true, traction);
    const auto by_loads = [&](double alpha, double depth) {
      internal::FromFace sum{};
      for_line_loads(half_length, traction, alpha, [&](data::SheetLoad load, double size, double from) {
        sum.u -= size * sheet_u(from, depth, load, material.poisson);
        sum.v += size * sheet_v(from, 0, depth, load, material.poisson);
      });
      return sum;
    };
    for (const double alpha : {0.0, 0.3 * half_length, -half_length, half_length + 0.4, half_length + 3}) {
      CAPTURE(half_length, alpha);
      constexpr double deep = 0.25, other = 0.5;
      const internal::FromFace here = field.from_face({alpha, deep}, share),
                               there = field.from_face({alpha, -other}, share);
      const internal::FromFace loads = by_loads(alpha, deep), others = by_loads(alpha, other);
      CHECK(std::fabs(here.u / deep - there.u / other - (loads.u / deep - others.u / other)) <
            1e-13 * (1 + half_length));
      CHECK(std::fabs(here.v - there.v - (loads.v - others.v)) < 1e-13 * (1 + half_length));
    }
    CHECK(field.from_face({0.3, 1}, share).u == 0);
    CHECK(std::fabs(field.from_face({0.3, 1 - 1e-9}, share).v) < 1e-7);
  }
}

TEST_CASE("kernels of displacements from the face are as large as errors take them for, and hardly smaller") {
  double largest = 0, integral = 0;
  for (const data::SheetLoad load : {data::SheetLoad::normal, data::SheetLoad::shear}) {
    for (const double poisson : {-0.99, -0.5, 0.0, 0.3, 0.499}) {
      for (const double depth : {0.0, 0.05, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999}) {
        const auto u = [&](double a) {
          return sheet_u(a, depth, load, poisson) - depth * sheet_u(a, 1, load, poisson);
        };
        const auto v = [&](double a) {
          return sheet_v(a, 0, depth, load, poisson) - sheet_v(a, 0, 1, load, poisson);
        };
        double of_u = 0, of_v = 0;
        constexpr double step = 0.05;
        for (double log_distance = -16; log_distance < 3; log_distance += step) {
          const double a = std::exp(log_distance);
          of_u += 2 * a * std::fabs(u(a)) * step;
          of_v += 2 * a * std::fabs(v(a)) * step;
          if (a < 1)
            largest = std::max(largest, std::max(std::fabs(u(a)), std::fabs(v(a))) / (1 - log_distance));
        }
        integral = std::max({integral, of_u, of_v});
      }
    }
  }
  CHECK(largest * std::numbers::pi <= 1);
  CHECK(largest * std::numbers::pi >= 0.9);
  CHECK(integral <= 0.8);
  CHECK(integral >= 0.75);
}
