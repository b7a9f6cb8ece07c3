#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <nipref/ref/number/float.hpp>
#include <nipref/verify/catalogue/named_point.hpp>

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

namespace confirm {

using Arguments = const NamedPoint&;

/// Second methods by the names of their quantities.
using Methods = std::map<std::string, Confirm, std::less<>>;

const Methods& sheet_methods();  ///< roots, kernels and displacements of the elastic sheet
/// The field inside the sheet. For |alpha| <= 3 the method adds the fields of two half-planes under the loads and the
/// integrals along the real axis of the thesis's integrands without them; beyond, it integrates around the poles.
const Methods& field_methods();
const Methods& memory_methods();     ///< J1 to J6 and the displacements under a moving load
const Methods& material_methods();   ///< material.*
const Methods& nip_methods();        ///< nip.* and rolling_nip.*
const Methods& isotropic_methods();  ///< lines, dies, spheres and ellipses on isotropic half-spaces
/// Lines and critical speeds of half-spaces of any anisotropy, and spheres on transversely isotropic ones.
const Methods& anisotropic_methods();

}  // namespace confirm

}  // namespace nipref::verify
