#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/converged.hpp>

namespace nipref::fast {

/// The contact of length L = `contact_length`, unit of length: 1e-8 <= L/B <= 1e4 and L <= R; a parabola does not stand
/// for the circle in a longer contact. accuracy: relative, 1e-13 <= accuracy <= 0.1. BadInput otherwise. With full
/// friction the creep is an unknown with one value. (thesis 2.1-2.6, 5.3, 5.5)
ConvergedNip converged_for_length(const data::ElasticNip& nip, data::Friction friction, double contact_length,
                                  double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, with a contact length as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ElasticNip& nip, data::Friction friction, double load,
                                double accuracy);

}  // namespace nipref::fast
