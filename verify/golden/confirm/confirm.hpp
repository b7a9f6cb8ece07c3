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
  ref::Float error;  ///< estimate: the change of the value when the method's own work is halved
};

using Confirm = std::function<Confirmation(const NamedPoint& point)>;

/// The second method for the quantity of that name; empty if there is none.
Confirm confirmer_of(std::string_view quantity);

/// Results of a contact by a second method, in the scene's units.
struct SecondSolution {
  std::string method;
  std::vector<std::pair<data::ResultId, ref::Estimate>> numbers;
};

/// Solves the scene by a second method; empty if none reaches such a contact.
std::function<SecondSolution()> second_solver(const data::Scene& scene);

namespace confirm {

using Arguments = const NamedPoint&;

/// Second methods by the names of their quantities.
using Methods = std::map<std::string, Confirm, std::less<>>;

/// Roots, kernels, displacements of the elastic sheet and the field inside it. For |alpha| <= 3 that of the field adds the
/// fields of two half-planes under the loads and the integrals along the real axis of the thesis's integrands without them;
/// beyond, it integrates around the poles.
Methods sheet_methods();
Methods memory_methods();     ///< J1 to J6 and the displacements under a moving load
Methods material_methods();   ///< material.*
Methods nip_methods();        ///< nip.* and rolling_nip.*
Methods isotropic_methods();  ///< lines, dies, spheres and ellipses on isotropic half-spaces
/// Lines and critical speeds of half-spaces of any anisotropy, and spheres on transversely isotropic ones.
Methods anisotropic_methods();

}  // namespace confirm

}  // namespace nipref::verify
