#pragma once
#include <functional>
#include <optional>
#include <string>

#include <nipref/ref/nip/converged.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// The exact units of the dimensionless contact.
struct NipUnits {
  mpq_class length;        ///< b
  mpq_class slope;         ///< b/(2R)
  mpq_class displacement;  ///< b^2/(2R)
  mpq_class pressure;      ///< b/(2 R N), N at once
  mpq_class force;         ///< b^2/(2 R N)

  NipUnits(double roller_radius, double sheet_thickness, const mpq_class& compliance)
      : length(mpq_class(sheet_thickness) / 2),
        slope(length / (2 * mpq_class(roller_radius))),
        displacement(slope * length),
        pressure(slope / compliance),
        force(pressure * length) {}
};

/// A nip to be solved to `digits` digits. The reference solves contacts from `shortest` to `most` sheet thicknesses.
struct NipTask {
  double roller_radius, sheet_thickness;
  const char* kind;
  int most_digits;
  double shortest;
  int digits;
  double most = 1000;  ///< largest L/B; `shortest` is the smallest

  void check_digits() const;  ///< BadInput if they are too few or too many
  [[nodiscard]] bool allows(double contact_length) const;
  /// The half length in half-thicknesses; BadInput if the contact length is not allowed.
  [[nodiscard]] Exact half_length(double contact_length) const;
  [[nodiscard]] double longest() const;  ///< the largest L/B that is allowed
  [[noreturn]] void refuse_load(double load) const;
  /// The contact of a load, solved by panels. `wanted` is the dimensionless load. BadInput if no allowed length has it.
  [[nodiscard]] SolvedNip solved_for_load(const SolvedNip::Sheet& sheet, double load, const Float& wanted,
                                          double guess) const;

 private:
  [[nodiscard]] std::string allowed_lengths() const;
};

/// A guess of the dimensionless half length that carries a load without friction, from an interpolation between a
/// half-space and springs. It is a few tens of per cent off at most. `softness` is the compliance that a contact of a
/// half length meets, over the compliance at once.
double guessed_half_length(double load, const std::function<double(double half_length)>& softness);

struct ConvergedNip::Parts {
  NipUnits units;
  SolvedNip::Sheet sheet;
  int digits;
  std::optional<Exact> half_length = std::nullopt;  ///< if it is given
  std::optional<Proof> proof = std::nullopt;
  /// The solution by panels. If it is empty, it is computed when it is first needed.
  mutable std::optional<SolvedNip> solved = std::nullopt;

  [[nodiscard]] int working_digits() const { return SolvedNip::working_digits(digits, sheet->lost_digits()); }
};

}  // namespace nipref::ref
