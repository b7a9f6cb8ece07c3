#pragma once
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One hard case of a contact in double.
struct ContactAudit {
  std::string system;  ///< method and friction
  double ratio;        ///< contact length over sheet thickness
  double poisson;
  int unknowns;
  std::optional<double> condition;    ///< of the line loads' matching matrix
  std::optional<double> oscillation;  ///< of the shear with friction, see fast::oscillation
  double allowed;                     ///< 1e-15 of the condition, or the solution's own estimate
  /// The error relative to ref, where ref has the system: of the line loads over the largest load, of a converged
  /// contact that of its load.
  std::optional<double> error = {};
  /// For frictionless line loads: the part of `error` caused by the rounding of the kernel values (the rest is the
  /// rounding of the solution, which the condition number magnifies), and the relative difference of the load from
  /// that of the continuous contact.
  std::optional<double> kernel_error = {};
  std::optional<double> discretisation_error = {};

  /// Nothing if there is no independent value to compare with.
  [[nodiscard]] std::optional<bool> kept() const {
    return error ? std::optional(*error <= allowed) : std::nullopt;
  }
  /// See stored.hpp.
  static void members(auto& self, const auto& each) {
    each("system", self.system, "length_over_thickness", self.ratio, "poisson", self.poisson, "unknowns",
         self.unknowns, "condition", self.condition, "oscillation", self.oscillation, "error", self.error,
         "allowed", self.allowed, "kernel_error", self.kernel_error, "discretisation_error",
         self.discretisation_error);
  }
};

/// The hard cases: L/B from 1e-4 to 1e3, Poisson's ratio from -0.9 to 0.5, up to 500 elements a side. A group has one
/// kind of friction, one Poisson's ratio, one L/B, and all numbers of elements.
inline constexpr std::size_t hard_case_groups = 30;
std::vector<ContactAudit> audit_hard_cases(std::size_t group);

Json contact_audit_json(const std::vector<ContactAudit>& audits);

/// True if no audit has found an error above the allowed one.
bool all_kept(const std::vector<ContactAudit>& audits);

}  // namespace nipref::verify
