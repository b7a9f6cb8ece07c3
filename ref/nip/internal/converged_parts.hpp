#pragma once
#include <functional>
#include <optional>
#include <string>

#include <nipref/ref/nip/converged.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/ref/nip/internal/proven_contact.hpp>
#include <nipref/ref/number/exact.hpp>

namespace nipref::ref {

/// Units of the dimensionless contact, exactly.
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

/// A nip that is to be solved to so many digits, and of which the reference solves contacts from `shortest` to `most` sheet
/// thicknesses.
struct NipTask {
  double roller_radius, sheet_thickness;
  const char* kind;
  int most_digits;
  double shortest;
  int digits;
  double most = 1000;  ///< L/B

  void check_digits() const;  ///< BadInput
  [[nodiscard]] bool allows(double contact_length) const;
  /// In half-thicknesses; BadInput unless it is allowed.
  [[nodiscard]] Exact half_length(double contact_length) const;
  [[nodiscard]] double longest() const;  ///< L/B
  [[noreturn]] void refuse_load(double load) const;
  /// By panels; `wanted` is the load without its unit. BadInput where no allowed length carries it.
  [[nodiscard]] SolvedNip solved_for_load(const SolvedNip::Sheet& sheet, double load, const Float& wanted,
                                          double guess) const;

 private:
  [[nodiscard]] std::string allowed_lengths() const;
};

/// A guess at the half length that carries a load without friction, a few tens of per cent off at most: between a
/// half-space and springs; dimensionless. `softness`: the compliance over that at once which a contact so long meets.
double guessed_half_length(double load, const std::function<double(double half_length)>& softness);

struct ConvergedNip::Parts {
  NipUnits units;
  SolvedNip::Sheet sheet;
  int digits;
  std::optional<Exact> half_length = std::nullopt;  ///< where it is given
  std::optional<Proof> proof = std::nullopt;
  /// Where it is not there yet, it is solved when it is first needed.
  mutable std::optional<SolvedNip> solved = std::nullopt;

  [[nodiscard]] int working_digits() const { return SolvedNip::working_digits(digits, sheet->lost_digits()); }
};

}  // namespace nipref::ref
