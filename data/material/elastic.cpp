#include <nipref/data/internal/common.hpp>
#include <nipref/data/material/elastic.hpp>

namespace nipref::data {

void ElasticMaterial::check() const {
  check_magnitude("young", young);
  if (!(poisson > -1 && poisson <= 0.5))
    throw BadInput("poisson", poisson, "must satisfy -1 < poisson <= 0.5");
}

}  // namespace nipref::data
