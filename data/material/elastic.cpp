#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/material/elastic.hpp>

namespace nipref::data {

void ElasticMaterial::check() const {
  if (!(std::isfinite(young) && young > 0)) throw BadInput("young", young, "must be finite and > 0");
  if (!(poisson > -1 && poisson <= 0.5))
    throw BadInput("poisson", poisson, "must satisfy -1 < poisson <= 0.5");
}

}  // namespace nipref::data
