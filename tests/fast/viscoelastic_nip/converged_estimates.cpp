// Estimates of rolling contacts that random scenes showed to be too small.
#include <doctest/doctest.h>

#include <cmath>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/fast/viscoelastic_nip/converged.hpp>

using namespace nipref;

TEST_CASE("thin sheet with a short memory, little asked: the quadrature is not what is left") {
  // Its many panels leave out less than the quadrature did whose tolerance went with what they may leave out.
  const data::ViscoelasticNip nip{18.923064846545458, 0.006449549600802129,
                                  data::operator_solid({{143142339.890625, 1.0},
                                                        {57438.41528701782, 0.03996054705203278},
                                                        {7495473.203125, 1.0},
                                                        {321172.29263305664, 4.267132258042693}}),
                                  0.5422828955342993};
  const double length = 0.46639424486784264;
  const auto asked = fast::converged_for_length(nip, length, 1.5e-3);
  const auto truth = fast::converged_for_length(nip, length, 1e-13);
  const auto check = [](const fast::Estimate& found, const fast::Estimate& other) {
    CHECK(std::fabs(found.value - other.value) <= found.error + other.error);
  };
  check(asked.load(), truth.load());
  check(asked.peak_pressure(), truth.peak_pressure());
  for (const double y : {0.0, 0.13, -0.13, 0.233, -0.233}) check(asked.pressure(y), truth.pressure(y));
}
