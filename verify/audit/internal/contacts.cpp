#include <nipref/fast/elastic_nip/converged.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/verify/audit/internal/work.hpp>
#include <nipref/verify/support/internal/interrupt.hpp>

namespace nipref::verify {
namespace {

using data::ElasticNip;
using data::Friction;

constexpr std::array length_ratios{1e-4, 1e-2, 1.0, 30.0, 1e3};
constexpr std::array poissons{-0.9, 1.0 / 3, 0.5};
constexpr std::array elements{10, 500};
constexpr int contact_digits = 20;
constexpr int most_ref_elements = 40;
constexpr double longest_ref_line_loads = 500;
constexpr double longest_ref_converged = 12;
constexpr double contact_accuracy = 1e-10;

/// A nip with R = 1 and a thickness such that L <= R.
ElasticNip nip_for(double ratio, double poisson) { return {1, 1e-3 / std::max(ratio, 1.0), {1, poisson}}; }

std::string name(const char* method, Friction friction) {
  return fmt::format("{}, {}", method, friction == Friction::full ? "full friction" : "no friction");
}

/// The largest difference over the largest value.
double error_of(const fast::LineLoadNip& nip, double fast::FaceLoad::*kind, const ref::LineLoadNip& truth,
                ref::Estimate ref::FaceLoad::*true_kind) {
  double error = 0, size = 0;
  const std::vector<ref::FaceLoad> true_loads = truth.face_loads();
  for (std::size_t j = 0; j < nip.loads.size(); ++j) {
    const double load = nip.loads[j].*kind;
    if (!std::isfinite(load)) return std::numeric_limits<double>::infinity();
    error = std::max(error, std::fabs((true_loads[j].*true_kind).error_of(load)));
    size = std::max(size, std::fabs(load));
  }
  return error / size;
}

/// Finds the part of a frictionless solution's error that its kernel values cause, and the discretisation error.
void split_error(ContactAudit& audit, const ElasticNip& nip, double length, int m,
                 const fast::LineLoadNip& solution, const ref::LineLoadNip& truth) {
  std::vector<double> kernel;
  for (int q = 0; q < 2 * m; ++q)
    kernel.push_back(fast::I1((2 * q + 1) * length / (4 * m) / nip.half_thickness()));
  const auto exactly_solved =
      ref::line_loads_from_kernel_values(nip, kernel, length, contact_digits).face_loads();
  const auto true_loads = truth.face_loads();
  double kernel_error = 0, size = 0;
  for (std::size_t j = 0; j < solution.loads.size(); ++j) {
    const double computed = solution.loads[j].normal;
    const double by_rounding = exactly_solved[j].normal.error_of(computed);
    size = std::max(size, std::fabs(computed));
    kernel_error = std::max(kernel_error, std::fabs(true_loads[j].normal.error_of(computed) - by_rounding));
  }
  audit.kernel_error = kernel_error / size;
  const double continuous =
      fast::converged_for_length(nip, Friction::none, length, contact_accuracy).load().value;
  audit.discretisation_error = solution.load() / continuous - 1;
}

/// The oscillation of the shear from the middle outwards, see fast::oscillation.
double oscillation_of(const fast::LineLoadNip& nip) {
  std::vector<double> shear;
  for (std::size_t j = nip.loads.size() / 2; j < nip.loads.size(); ++j) shear.push_back(nip.loads[j].shear);
  return fast::oscillation(shear);
}

ContactAudit audit_line_loads(Friction friction, double ratio, double poisson, int m) {
  const ElasticNip nip = nip_for(ratio, poisson);
  const double length = ratio * nip.sheet_thickness;
  const bool shear = friction == Friction::full;
  const double creep = 1e-2 * length;
  const auto friction_and_creep = shear ? data::LineLoadFriction::full(creep) : data::LineLoadFriction{};
  const auto solution = fast::line_loads_for_length(nip, m, length, friction_and_creep);
  const double condition = fast::condition_number(nip, m, length, friction);
  ContactAudit audit{name("line loads", friction),
                     ratio,
                     poisson,
                     solution.work().unknowns,
                     condition,
                     shear ? std::optional(oscillation_of(solution)) : std::nullopt,
                     1e-15 * condition};
  if (m > most_ref_elements || ratio > longest_ref_line_loads) return audit;
  const auto truth = ref::line_loads_for_length(nip, m, length, contact_digits, friction_and_creep);
  audit.error = error_of(solution, &fast::FaceLoad::normal, truth, &ref::FaceLoad::normal);
  if (shear) {
    audit.error =
        std::max(*audit.error, error_of(solution, &fast::FaceLoad::shear, truth, &ref::FaceLoad::shear));
  } else {
    split_error(audit, nip, length, m, solution, truth);
  }
  return audit;
}

/// Shear in the middles of `count` equal elements, as line loads would have it.
std::vector<double> sampled_shear(const fast::ConvergedNip& contact, int count) {
  const double half = contact.contact_length().value / 2;
  std::vector<double> shear;
  for (int k = 0; k < count; ++k) shear.push_back(contact.shear(half * (k + 0.5) / count).value);
  return shear;
}

ContactAudit audit_converged(Friction friction, double ratio, double poisson) {
  const ElasticNip nip = nip_for(ratio, poisson);
  const double length = ratio * nip.sheet_thickness;
  const auto contact = fast::converged_for_length(nip, friction, length, contact_accuracy);
  const fast::Estimate load = contact.load();
  const bool shear = friction == Friction::full;
  ContactAudit audit{name("converged", friction),
                     ratio,
                     poisson,
                     contact.work().unknowns,
                     std::nullopt,
                     shear ? std::optional(fast::oscillation(sampled_shear(contact, 40))) : std::nullopt,
                     load.error / load.value};
  if (shear || ratio > longest_ref_converged) return audit;
  const ref::Estimate truth = ref::converged_for_length(nip, friction, length, contact_digits).load();
  audit.error = std::fabs(truth.error_of(load.value)) / load.value;
  return audit;
}

}  // namespace

std::vector<ContactAudit> audit_hard_cases(std::size_t group) {
  static_assert(hard_case_groups == 2 * poissons.size() * length_ratios.size());
  const double ratio = length_ratios[group % length_ratios.size()];
  const double poisson = poissons[group / length_ratios.size() % poissons.size()];
  const Friction friction = group < hard_case_groups / 2 ? Friction::none : Friction::full;
  auto audits = mapped(elements, [&](int m) { return audit_line_loads(friction, ratio, poisson, m); });
  audits.push_back(audit_converged(friction, ratio, poisson));
  return audits;
}

std::unique_ptr<ListWork<ContactAudit>> hard_cases_work() {
  const auto audit_group = [](std::size_t group, const OnProgress&) {
    stop_if_interrupted();
    return audit_hard_cases(group);
  };
  return std::make_unique<ListWork<ContactAudit>>("contacts", hard_case_groups, "hard cases", audit_group);
}

Json contact_audit_json(const std::vector<ContactAudit>& audits) {
  return json_list(audits, [](const ContactAudit& audit) {
    Json row = Json::object();
    ContactAudit::members(audit,
                          EachPart{[&](std::string_view key, const auto& part) { row.set(key, part); }});
    row.append({{"allowance_used", audit.error ? Json(*audit.error / audit.allowed) : Json()},
                {"passed", audit.kept()},
                {"_without_truth", !audit.kept().has_value()}});
    return row;
  });
}

}  // namespace nipref::verify
