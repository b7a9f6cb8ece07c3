#pragma once
#include <nipref/data/material/spring_model.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// A modulus of a linear viscoelastic solid with exact constants; constants that the model does not have are ignored.
/// Moduli in stress, viscosities in stress time, > 0; otherwise check() throws BadInput that names prefix + member.
struct ExactModulus {
  data::SpringModel model;
  Exact spring, second_spring, viscosity;

  void check(const char* prefix) const;
};

// The functions are defined as fast::relaxation and its neighbours; t and omega >= 0, digits 16 to 1000. The bound is
// proven by interval arithmetic on the partial fractions.

Enclosure relaxation(const ExactModulus& modulus, const Exact& t, int digits);
Enclosure creep(const ExactModulus& modulus, const Exact& t, int digits);
Enclosure storage(const ExactModulus& modulus, const Exact& omega, int digits);
Enclosure loss(const ExactModulus& modulus, const Exact& omega, int digits);
Enclosure theta1(const ExactModulus& shear, const Exact& t, int digits);
Enclosure theta2(const ExactModulus& shear, const ExactModulus& bulk, const Exact& t, int digits);

}  // namespace nipref::ref
