// Line loads in multiprecision: bounds, independent routes, and what the double path loses against them.

#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/nip/line_load_field.hpp>
#include <nipref/ref/sheet/displacements.hpp>

#include "support/reference_values.hpp"
#include "support/test.hpp"
#include "support/thesis_nips.hpp"

using namespace nipref;
using test::full_friction;
using test::quarter_inch_nip;

TEST_CASE("ref line loads: fewer digits enclose more digits") {
  for (const double length : {1e-3, 0.1, 2.0}) {
    const auto coarse = ref::line_loads_for_length(quarter_inch_nip, 4, length, 20, full_friction(1e-3));
    const auto fine = ref::line_loads_for_length(quarter_inch_nip, 4, length, 60, full_friction(1e-3));
    CHECK(meet(coarse.indentation(), fine.indentation()));
    CHECK(error(coarse.indentation()) <= 1e-20 * std::fabs(coarse.indentation().to_double()) * 1e3);
    const auto coarse_loads = coarse.face_loads(), fine_loads = fine.face_loads();
    for (std::size_t j = 0; j < 8; ++j) {
      CHECK(difference(coarse_loads[j].normal, fine_loads[j].normal) <= error(coarse_loads[j].normal));
      CHECK(difference(coarse_loads[j].shear, fine_loads[j].shear) <= error(coarse_loads[j].shear));
    }
  }
}

TEST_CASE("ref line loads displace the sheet to the roller, summed load by load without the symmetry") {
  const int m = 3;
  const ref::Exact young(quarter_inch_nip.material.young), poisson(quarter_inch_nip.material.poisson);
  const double length = 0.375, creep = -0.0009765625;  // exact in binary, and so are all distances
  const auto solution = ref::line_loads_for_length(quarter_inch_nip, m, length, 40, full_friction(creep));
  const auto loads = solution.face_loads();
  for (int i = -m; i <= m; ++i) {
    double u = 0, v = 0;
    for (int k = -m; k < m; ++k) {
      const ref::FaceLoad& load = loads[static_cast<std::size_t>(m - 1 - k)];
      const double force = load.normal.to_double(), shear = load.shear.to_double();
      const ref::Exact alpha((2 * (i - k) - 1) * length / (4 * m) / 0.125);
      const ref::Exact eta(-(2 * k + 1) * length / (4 * m) / 0.125);
      u += force * ref::un(alpha, young, poisson, 20).to_double() +
           shear * ref::us(alpha, young, poisson, 20).to_double();
      v += force * ref::vn(alpha, eta, young, poisson, 20).to_double() +
           shear * ref::vs(alpha, eta, young, poisson, 20).to_double();
    }
    const double y = i * length / (2 * m);
    CHECK(u == approx(solution.indentation().to_double() - y * y / 12, 1e-12));
    CHECK(std::fabs(v - creep * y) < 1e-12 * std::fabs(creep) * length);
  }
}

TEST_CASE("fast line loads are within their condition of the truth, by errors of kernels and rounding") {
  for (const int m : {2, 10, 40}) {
    for (const double length : {0.01, 0.1, 1.0}) {
      CAPTURE(m, length);
      const auto truth = ref::line_loads_for_length(quarter_inch_nip, m, length, 30);
      const auto computed = fast::line_loads_for_length(quarter_inch_nip, m, length);
      CHECK(relative_error(truth.indentation(), computed.indentation) < 1e-16 * truth.condition() + 4e-16);
      CHECK(relative_error(truth.load(), computed.load()) < 1e-16 * truth.condition() + 4e-16);

      std::vector<double> kernel;
      for (int q = 0; q < 2 * m; ++q) kernel.push_back(fast::I1((2 * q + 1) * length / (4 * m) / 0.125));
      const auto exact_solve = ref::line_loads_from_kernel_values(quarter_inch_nip, kernel, length, 30);
      const double by_kernels = difference(exact_solve.load(), truth.load());
      const double by_rounding = std::fabs(exact_solve.load().error_of(computed.load()));
      CHECK(std::fabs(truth.load().error_of(computed.load())) <= 1.01 * (by_kernels + by_rounding));
    }
    const auto truth = ref::line_loads_for_length(quarter_inch_nip, m, 0.1, 30, full_friction(1e-4));
    const auto computed = fast::line_loads_for_length(quarter_inch_nip, m, 0.1, full_friction(1e-4));
    CHECK(relative_error(truth.load(), computed.load()) < 1e-15 * truth.condition());
  }
}

TEST_CASE("ref line loads: inside the sheet the field is proven, and covers what a place that is off does") {
  const double half_thickness = 0.5, off = 1e-7;
  const std::vector<ref::InnerPoint> points{{0.1, 0.3}, {0.25, -0.6}, {2, 0}};
  const data::ElasticMaterial material{2, 0.25};
  const auto loads_at = [](const ref::Enclosure& y) {
    return std::vector<ref::FaceLoad>{{y, ref::exactly(3, 30), ref::exactly(1, 30)},
                                      {-1 * y, ref::exactly(3, 30), ref::exactly(-1, 30)}};
  };
  const auto numbers_of = [&](const std::vector<ref::FaceLoad>& loads) {
    std::vector<ref::Estimate> numbers;
    for (const ref::InnerStresses& stress : ref::line_load_stresses(loads, half_thickness, points, 30))
      numbers.insert(numbers.end(), {stress.across, stress.along, stress.shear, stress.highest(),
                                     stress.lowest(), stress.maximum_shear()});
    for (const auto& moved : ref::line_load_displacements(loads, half_thickness, material, points, 30))
      numbers.insert(numbers.end(), {moved.across, moved.along});
    return numbers;
  };
  const auto wide = numbers_of(loads_at(ref::Enclosure(0.25, off, 30)));
  std::vector<double> largest(wide.size(), 0);
  for (const double share : {-1.0, -0.4, 0.0, 0.7, 1.0}) {
    const auto exact = numbers_of(loads_at(ref::exactly(0.25 + share * off, 30)));
    for (std::size_t k = 0; k < wide.size(); ++k) {
      CAPTURE(k);
      CHECK(wide[k].proven);
      CHECK(exact[k].proven);
      CHECK(error(exact[k]) < 1e-28);
      CHECK(meet(wide[k], exact[k]));
      largest[k] = std::max(largest[k], difference(wide[k], exact[k]));
    }
  }
  for (std::size_t k = 0; k < wide.size(); ++k) CHECK(error(wide[k]) <= 50 * largest[k] + 1e-9);
  const std::vector<ref::InnerPoint> face{{0.1, 1}};
  CHECK_FALSE(
      ref::line_load_stresses(loads_at(ref::exactly(0.25, 30)), half_thickness, face, 30)[0].along.proven);
}

TEST_CASE("ref line loads refuse bad input by name") {
  const auto of_length = [](const auto& method, double length, int digits,
                            const data::LineLoadFriction& friction = {}) {
    return ref::line_loads_for_length(quarter_inch_nip, method, length, digits, friction);
  };
  CHECK_REFUSED(of_length(0, 0.1, 30), "elements_per_side");
  CHECK_REFUSED(ref::line_loads_for_load(quarter_inch_nip, 2, -1, 30), "load = -1");
  CHECK_REFUSED(ref::line_loads_for_length(quarter_inch_nip, {2, 501}, 0.1, 30), "residue_terms = 501");
  CHECK_REFUSED(of_length(2, -0.1, 30), "contact_length");
  CHECK_REFUSED(of_length(2, 0.1, 5), "digits");
  CHECK_REFUSED(of_length(2, 0.1, 30, full_friction(HUGE_VAL)), "creep");
  // With one value for all distances the rows of the matrix are equal, and no number of digits helps.
  const std::array<double, 3> odd{1, 2, 3};
  const std::array<double, 4> singular{1, 1, 1, 1};
  CHECK_REFUSED(ref::line_loads_from_kernel_values(quarter_inch_nip, odd, 0.1, 30), "kernel");
  CHECK_REFUSED(ref::line_loads_from_kernel_values(quarter_inch_nip, singular, 0.1, 30), "kernel = 1");
}

TEST_CASE("ref line loads: a given load is carried at a length that is proven, whatever the digits") {
  for (const auto kind : {data::LineLoadFriction::Kind::none, data::LineLoadFriction::Kind::given_creep,
                          data::LineLoadFriction::Kind::thesis_creep}) {
    const data::LineLoadFriction friction{kind, kind == data::LineLoadFriction::Kind::given_creep ? 1e-4 : 0};
    const auto coarse = ref::line_loads_for_load(quarter_inch_nip, 3, 100, 18, friction);
    const auto fine = ref::line_loads_for_load(quarter_inch_nip, 3, 100, 34, friction);
    CHECK(difference(coarse.contact_length(), fine.contact_length()) <= error(coarse.contact_length()));
    CHECK(difference(coarse.indentation(), fine.indentation()) <= error(coarse.indentation()));
    CHECK(difference(coarse.peak_pressure(), fine.peak_pressure()) <= error(coarse.peak_pressure()));
    CHECK(error(coarse.contact_length()) <= 1e-18 * coarse.contact_length().to_double());
    CHECK(std::fabs(fine.load().to_double() - 100) <= 1e-13);
    CHECK(error(fine.load()) <= 1e-30);
  }
}
