#include <nipref/data/internal/common.hpp>
#include <nipref/data/material/solids.hpp>

namespace nipref::data {

void IsotropicSolid::check() const {
  check_magnitude("shear", shear);
  check_magnitude("density", density);
  if (!(poisson > -1 && poisson < 0.5)) throw BadInput("poisson", poisson, "must satisfy -1 < poisson < 0.5");
}

void TransverselyIsotropicSolid::check() const {
  check_magnitude("c11", c11);
  check_magnitude("c33", c33);
  check_magnitude("c44", c44);
  check_magnitude("c66", c66);
  check_magnitude("density", density);
  if (!(c11 > c66)) throw BadInput("c11", c11, "must be > c66: the strain energy must be positive");
  if (!(std::fabs(c13) < std::sqrt(c11 - c66) * std::sqrt(c33))) {
    throw BadInput(
        "c13", c13,
        "must be smaller in magnitude than sqrt((c11 - c66) c33): the strain energy must be positive");
  }
}

}  // namespace nipref::data
