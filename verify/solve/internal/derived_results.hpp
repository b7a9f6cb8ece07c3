#pragma once
#include <nipref/verify/solve/internal/solved_contact.hpp>
#include <nipref/verify/solve/solve.hpp>

namespace nipref::verify {

/// Whether it is leading_moment or trailing_moment.
bool is_moment(ResultId id);

/// Sets the results of a nip that are products of others; the errors follow from those of the factors:
///   eccentricity = R mu_R, resistance_force = W mu_R, power_loss = speed W mu_R     (thesis 7.12, 7.14, 7.15)
template <class Number>
void set_products(SolvedContact<Number>& contact);

/// The factor of mu_R in such a product.
template <class Number>
double product_factor(const SolvedContact<Number>& contact, ResultId id);

/// Sets leading_moment = int p Y dY ahead of the line through the rollers' centres, and trailing_moment behind it
/// (thesis 7.13), by Gauss's rule. The error is the integrated error of the pressure and twice the difference from half
/// as many nodes.
void set_moments(SolvedContact<fast::Estimate>& contact);

/// Sets slip = v' - creep ratio, v' the strain of the surface: by (2.5) the surface moves at F_0 (1 + v') and the
/// rollers at F_0 (1 + creep ratio), so that the slip is the velocity of sliding over F_0. It is 0 in a contact with
/// full friction. Without friction the creep ratio is the mean strain, so that the mean slip in the contact is 0.
/// Outside the contact it is the slip that there would be if the surfaces touched.
void set_slip(SolvedContact<ref::Estimate>& contact, bool has_full_friction);

}  // namespace nipref::verify
