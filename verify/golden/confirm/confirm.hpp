#pragma once
#include <nipref/data/scene/scene.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// The value of a quantity at a point by a second method, which uses neither the code that computes the golden value
/// nor its arithmetic: its numbers are Boost's over MPFR and MPC.
struct Confirmation {
  std::string method;
  ref::Float value;
  ref::Float error;  ///< estimate: the difference from a coarser rule, or an allowance for rounding errors
};

using Confirm = std::function<Confirmation(const NamedPoint& point)>;

/// The second method for the quantity of this name; empty if there is none.
Confirm confirmer_of(std::string_view quantity);

/// Results of a contact by a second method, in the scene's units.
struct SecondSolution {
  std::string method;
  std::vector<std::pair<data::ResultId, ref::Estimate>> numbers;
};

/// Returns a function that solves the scene by a second method; empty if no second method covers such a contact.
std::function<SecondSolution()> second_solver(const data::Scene& scene);

namespace confirm {

using Arguments = const NamedPoint&;

/// Second methods by the names of their quantities.
using Methods = std::map<std::string, Confirm, std::less<>>;

/// Roots, kernels and displacements of the elastic sheet, and the field inside it. For |alpha| < 3 the field is that of
/// two half-planes under the loads, plus integrals along the real axis of the rest of the thesis's integrands. For
/// |alpha| >= 3 it is a sum of integrals around the poles.
Methods sheet_methods();
Methods memory_methods();     ///< J1 to J6 and the displacements under a moving load
Methods material_methods();   ///< material.*
Methods nip_methods();        ///< nip.* and rolling_nip.*
Methods isotropic_methods();  ///< lines, dies, spheres and ellipses on isotropic half-spaces
/// Lines and critical speeds of half-spaces of any anisotropy, and spheres on transversely isotropic ones.
Methods anisotropic_methods();

}  // namespace confirm

}  // namespace nipref::verify
