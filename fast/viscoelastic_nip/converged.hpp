#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/converged.hpp>

namespace nipref::fast {

/// The contact of length L = `contact_length`, unit of length, in steady frictionless rolling that began infinitely
/// long ago. Its place (the leading and the trailing length) is part of the solution. 1e-8 <= L/B <= 1e4 and L <= R; a
/// parabola does not stand for the circle in a longer contact. accuracy: relative, 1e-13 <= accuracy <= 0.1. BadInput
/// otherwise, naming "nip.material" if the compliance over the contact is more than 3e4 times the instantaneous one.
///
/// The equations are those of an elastic sheet with other right-hand sides (internal/rolling_equations.hpp), so that
/// only the elastic kernel is integrated; short memories are layers in closed form. (thesis 7.6, 7.15, 7.17)
ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, with a contact length as above; BadInput otherwise.
ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy);

}  // namespace nipref::fast
