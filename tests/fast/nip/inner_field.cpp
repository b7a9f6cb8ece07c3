#include <nipref/data/material/elastic.hpp>
#include <nipref/data/problem/seed_nips.hpp>
#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/sheet/field.hpp>

#include "support/covered.hpp"
#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;

namespace {

/// The stresses at a place by line loads in place of the contact's tractions, at the distances A x^4 from the ends.
SheetStresses by_line_loads(const ConvergedNip& contact, double half_length, double half_thickness,
                            const InnerPoint& at) {
  const GaussRule rule = gauss_legendre(400);
  SheetStresses sum{};
  for (const double side : {-1, 1}) {
    for (std::size_t j = 0; j < rule.at.size(); ++j) {
      const double x = rule.at[j], y = side * half_length * (1 - x * x * x * x),
                   width = 4 * half_length * x * x * x * rule.weight[j] / half_thickness;
      const auto add = [&](data::SheetLoad load, double traction) {
        const SheetStresses one = sheet_stresses((at.y - y) / half_thickness, at.depth, load);
        sum.across += width * traction * one.across;
        sum.along += width * traction * one.along;
        sum.shear += width * traction * one.shear;
      };
      add(data::SheetLoad::normal, contact.pressure(y).value);
      add(data::SheetLoad::shear, contact.shear(y).value);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("stresses inside are those of line loads, and next to a face those on it") {
  for (const double thickness : {0.02, 0.5}) {
    for (const data::Friction friction : {data::Friction::none, data::Friction::full}) {
      CAPTURE(thickness, friction);
      const data::ElasticNip nip = data::seed::nip(thickness);
      constexpr double length = 0.1;
      const ConvergedNip contact = converged_for_length(nip, friction, length, 1e-12);
      const double rounding = 1e-11 * contact.peak_pressure().value;
      for (const double depth : {0.0, -0.4, 0.6}) {
        for (const double y : {0.0, 0.37 * length / 2, -1.1 * length / 2}) {
          const InnerPoint at{y, depth};
          const InnerStresses here = contact.inner_stresses(std::span(&at, 1)).front();
          const SheetStresses loads = by_line_loads(contact, length / 2, nip.half_thickness(), at);
          CHECK(std::fabs(here.across.value - loads.across) < rounding);
          CHECK(std::fabs(here.along.value - loads.along) < rounding);
          CHECK(std::fabs(here.shear.value - loads.shear) < rounding);
        }
      }
      constexpr double near_face = 1e-9;
      for (const double y : {0.0, 0.37 * length / 2, -0.99 * length / 2, 1.02 * length / 2}) {
        const InnerPoint points[] = {{y, 1}, {y, 1 - near_face}, {y, near_face - 1}, {y, -1}};
        const auto all = contact.inner_stresses(points);
        for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
          const double near_enough = 1e2 * near_face * contact.peak_pressure().value;
          CHECK(std::fabs(all[i].across.value - all[i + 1].across.value) < near_enough);
          CHECK(std::fabs(all[i].along.value - all[i + 1].along.value) < near_enough);
          CHECK(std::fabs(all[i].shear.value - all[i + 1].shear.value) < near_enough);
        }
      }
    }
  }
}

TEST_CASE("the place of the greatest shear is as unsure as the shear is alike across the sheet") {
  const auto found = [](double accuracy) {
    return converged_for_length({100, 1, {1, -0.5}}, data::Friction::full, 40, accuracy).greatest_shear();
  };
  const GreatestShear truth = found(1e-12);
  for (const double accuracy : {1e-3, 1e-9}) {
    const GreatestShear rough = found(accuracy);
    check_covered(rough.value, truth.value);
    check_covered(rough.y, truth.y);
    check_covered(rough.depth, truth.depth);
    CHECK(rough.y.error < 1);
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

TEST_CASE("kernels of stresses are as large as errors take them for") {
  double largest = 0;
  for (const double distance : {1.0, 0.7, 0.3, 0.1, 1e-2, 1e-4, 1e-6}) {
    double across = 0, along = 0, under_shear = 0;
    constexpr double step = 0.05;
    for (double log_alpha = -24; log_alpha < 3; log_alpha += step) {
      const double a = std::exp(log_alpha);
      const SheetStresses pressed = sheet_stresses(a, 1 - distance, data::SheetLoad::normal);
      across += 2 * a * std::fabs(pressed.across) * step;
      along += 2 * a * std::fabs(pressed.along) * step;
      const SheetStresses sheared = sheet_stresses(a, 1 - distance, data::SheetLoad::shear);
      if (a < 1) under_shear += 2 * a * std::fabs(sheared.along) * step;
    }
    largest = std::max({largest, across, along});
    CHECK(under_shear <= 2 * std::numbers::inv_pi * std::log1p(std::pow(2 / distance, 2)));
  }
  CHECK(largest <= 2.01);
  CHECK(largest >= 1.99);
}
