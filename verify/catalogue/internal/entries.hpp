#pragma once
#include <array>
#include <vector>

#include <nipref/verify/catalogue/quantity.hpp>

namespace nipref::verify {

// The groups that the catalogue is put together from; to add a quantity, add its entry to one of them.

std::vector<Quantity> root_entries();         ///< roots of sinh 2z + 2z = 0, thesis appendix IV
std::vector<Quantity> kernel_entries();       ///< I1 to I7, thesis (4.9), (4.20)
std::vector<Quantity> memory_entries();       ///< J1 to J6, thesis (6.20)
std::vector<Quantity> moving_load_entries();  ///< Un, Vn, started and steady, thesis (6.23) to (6.28)
std::vector<Quantity> half_space_entries();   ///< K, S, isotropic, brock2012 (18a)
std::vector<Quantity>
transverse_half_space_entries();  ///< K, S and critical speeds, brock2013 (19), (43), (46)
std::vector<Quantity>
half_space_contact_entries();  ///< dies and spheres by the papers' rule, brock2012 (26) to (53)
std::vector<Quantity> elliptic_contact_entries();  ///< the exact frictionless contact, isotropic half-space
std::vector<Quantity> seed_sphere_entries();  ///< the seed's sphere, brock2013 (34), and its exact contact
std::vector<Quantity>
anisotropic_entries();  ///< K, S and critical speeds, any anisotropy, brock2013 appendix A
std::vector<Quantity> elastic_nip_entries();  ///< contacts of an elastic nip, dimensionless, thesis chapter V
std::vector<Quantity> displacement_entries();      ///< F1, F2, un, vn, us, vs, thesis (4.24), (4.25)
std::vector<Quantity> field_entries();             ///< inside the sheet, thesis (3.19), (3.20)
std::vector<Quantity> viscoelastic_nip_entries();  ///< of a rolling viscoelastic one, thesis chapter VII
std::vector<Quantity>
material_entries();  ///< theta1, theta2, moduli in time and at a frequency, thesis 6.12-6.17

// Arguments that several entries share, with their hard values.

Argument nonzero_position_argument(std::string name);
Argument position_argument(std::string name);

/// Of any quantity; the catalogue's test holds every entry to it.
inline constexpr std::size_t most_arguments = 32;

/// Sets the scalar evaluator and the loop over it; `evaluate` is known here as a type, so that the loop calls
/// it directly and is timed without the cost of std::function.
template <class Evaluate>
void set_fast(Quantity& entry, Evaluate evaluate) {
  entry.by_fast = evaluate;
  entry.by_fast_loop = [evaluate](Quantity::Columns columns, std::span<double> values,
                                  fast::Accuracy accuracy) {
    std::array<double, most_arguments> point{};
    const std::span<const double> arguments(point.data(), columns.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = 0; j < columns.size(); ++j) point[j] = columns[j][i];
      values[i] = evaluate(arguments, accuracy);
    }
  };
}

}  // namespace nipref::verify
