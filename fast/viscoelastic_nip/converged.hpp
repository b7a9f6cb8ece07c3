#pragma once
#include <nipref/data/problem/nip.hpp>
#include <nipref/fast/nip/converged.hpp>

namespace nipref::fast {

/// The contact of length L = `contact_length` in steady frictionless rolling, the load started infinitely long ago; the
/// place of the contact (its leading and trailing lengths) is part of the solution. 1e-8 <= L/B <= 1e4 and L <= R, beyond
/// which the parabola is no circle. accuracy: relative, 1e-13 <= accuracy <= 0.1. BadInput otherwise, naming "nip.material"
/// where the sheet gives way over the contact more than 3e4 times what it does at once.
///
/// It is the contact of an elastic sheet with other right-hand sides (viscoelastic_nip/internal/rolling_equations.hpp), so
/// that only the elastic kernel is integrated; short memories are layers in closed form. (thesis 7.6, 7.15, 7.17)
ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, double accuracy);

/// The contact that carries `load` per unit width, > 0 and finite, such that the contact length is as above;
/// BadInput otherwise.
ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, double accuracy);

}  // namespace nipref::fast
