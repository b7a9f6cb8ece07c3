#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One hard case of a contact in double.
struct ContactAudit {
  std::string system;  ///< line loads or converged, with or without friction
  double ratio;        ///< contact length over sheet thickness
  double poisson;
  int unknowns;
  std::optional<double> condition;    ///< of the line loads' matching matrix
  std::optional<double> oscillation;  ///< of the shear with friction, see fast::oscillation
  double allowed;                     ///< 1e-15 of the condition, or the solution's own estimate
  /// Against ref where ref has the system: of the line loads relative to the largest, of the converged load,
  /// relative.
  std::optional<double> error = {};
  /// Of frictionless line loads against ref: the part of `error` that the double kernel values make, the rest
  /// being the rounding of the solution, which the condition multiplies; and what the load lacks of the
  /// continuous contact's.
  std::optional<double> kernel_error = {};
  std::optional<double> discretisation_error = {};

  /// No verdict without a truth that is independent of the solution.
  [[nodiscard]] std::optional<bool> kept() const {
    return error ? std::optional(*error <= allowed) : std::nullopt;
  }
};

/// L/B from 1e-4 to 1e3, Poisson's ratio from -0.9 to 0.5, up to 500 elements a side. They come in groups of a friction,
/// a Poisson's ratio and an L/B, with as many elements as there are.
inline constexpr std::size_t hard_case_groups = 30;
std::vector<ContactAudit> audit_hard_cases(std::size_t group);

/// Of one of them as a block of a run tells it.
Json contact_audit_found(const ContactAudit& audit);
/// JsonMisfit for what contact_audit_found does not give.
ContactAudit contact_audit_of(const Json& found);

std::string contact_audit_text(const std::vector<ContactAudit>& audits);
Json contact_audit_json(const std::vector<ContactAudit>& audits);

/// True if no verdict is against a row.
bool all_kept(const std::vector<ContactAudit>& audits);

}  // namespace nipref::verify
