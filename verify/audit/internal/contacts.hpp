#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace nipref::verify {

/// One hard case of a contact in double.
struct ContactAudit {
  std::string system;  ///< line loads or converged, with or without friction
  double ratio;        ///< contact length over sheet thickness
  double poisson;
  int unknowns;
  double condition;    ///< of the line loads' matching matrix; 0 where it is not looked at
  double oscillation;  ///< of the outermost tractions, see fast::oscillation; 0 without friction
  /// Against ref where ref has the system: of the line loads relative to the largest, of the converged load,
  /// relative. Otherwise what condition or estimate say of it.
  double error;
  bool against_ref;
  double allowed;  ///< 1e-15 of the condition, or the solution's own estimate
  /// Of frictionless line loads against ref: the part of `error` that the double kernel values make, the rest
  /// being the rounding of the solution, which the condition multiplies; and what the load lacks of the
  /// continuous contact's.
  double kernel_error = 0;
  double discretisation_error = 0;

  [[nodiscard]] bool kept() const { return error <= allowed; }
};

/// L/B from 1e-4 to 1e3, Poisson's ratio from -0.9 to 0.5, up to 500 elements a side.
std::vector<ContactAudit> audit_contacts(const std::function<void(const std::string&)>& progress);

std::string contact_audit_text(const std::vector<ContactAudit>& audits);
nlohmann::ordered_json contact_audit_json(const std::vector<ContactAudit>& audits);

}  // namespace nipref::verify
