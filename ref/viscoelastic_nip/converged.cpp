#include <cmath>
#include <memory>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/converged_parts.hpp>
#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/viscoelastic_nip/converged.hpp>
#include <nipref/ref/viscoelastic_nip/internal/proven_rolling.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_sheet.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

NipTask task_of(const data::ViscoelasticNip& nip, int digits) {
  nip.check();
  const NipTask task{nip.roller_radius, nip.sheet_thickness, "a rolling contact", 30, 1e-6, digits};
  task.check_digits();
  return task;
}

void check_oscillation(const RollingMaterial& material) {
  constexpr double most_oscillation = 10;
  for (const RollingMemory& term : material.normal) {
    if (is_flow(term)) continue;
    const Float oscillation = term.rate.im / term.rate.re;
    if (oscillation > most_oscillation)
      throw BadInput("nip.material", static_cast<double>(oscillation),
                     "must have imaginary parts of rates at most 10 times the real parts for the reference");
  }
}

using Sheet = std::shared_ptr<const RollingSheet>;

/// The sheet with the results' digits and, in addition, those that its memories lose by cancellation.
Sheet sheet_to(int digits, int lost_digits, const data::ViscoelasticNip& nip) {
  const WorkingDigits working(SolvedNip::working_digits(digits, lost_digits));
  RollingMaterial material = rolling_material(nip);
  check_oscillation(material);
  return std::make_shared<const RollingSheet>(std::move(material));
}

/// The sheet at the working precision, which follows from the digits that the sheet loses.
Sheet sheet_of(const data::ViscoelasticNip& nip, int digits) {
  return sheet_to(digits, sheet_to(digits, 0, nip)->lost_digits(), nip);
}

ConvergedNip::Parts parts_of(const data::ViscoelasticNip& nip, const Sheet& sheet,
                             const std::optional<ProvenMemories>& memories, int digits) {
  const mpq_class compliance = memories ? memories->at_once : to_exact(sheet->material.compliance).value();
  return {NipUnits(nip.roller_radius, nip.sheet_thickness, compliance), sheet, digits};
}

/// The proof of contact_at(), called at the working precision that it needs; nothing if it is not proven to `digits`.
template <class ContactAt>
std::optional<Proof> proof_of(const std::optional<ProvenMemories>& memories, double half_length, int digits,
                              const ContactAt& contact_at) {
  constexpr double longest_proven = 4;
  if (!memories || half_length > longest_proven) return std::nullopt;
  const int working_digits = proven_rolling_working_digits(*memories, half_length, digits);
  const WorkingDigits working(working_digits);
  std::optional<ProvenContact> contact = contact_at();
  if (!contact || !contact->is_good_to(digits)) return std::nullopt;
  return Proof{std::make_shared<const ProvenContact>(*std::move(contact)), working_digits};
}

/// The number of unknowns of the first solution of a contact; BadInput if the reference does not solve it.
int checked_unknowns(const RollingSheet& sheet, const Exact& half_length, int digits) {
  const WorkingDigits working(SolvedNip::working_digits(digits, sheet.lost_digits()));
  sheet.check(half_length.approximate());
  return SolvedNip::first_unknowns(sheet, to_float(half_length), digits);
}

}  // namespace

int rolling_unknowns(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  const Exact half_length = task_of(nip, digits).half_length(contact_length);
  return checked_unknowns(*sheet_of(nip, digits), half_length, digits);
}

ConvergedNip converged_for_length(const data::ViscoelasticNip& nip, double contact_length, int digits) {
  const Exact half_length = task_of(nip, digits).half_length(contact_length);
  const Sheet sheet = sheet_of(nip, digits);
  checked_unknowns(*sheet, half_length, digits);
  const std::optional<ProvenMemories> memories = proven_memories(nip);
  ConvergedNip::Parts parts = parts_of(nip, sheet, memories, digits);
  parts.half_length = half_length;
  parts.proof = proof_of(memories, half_length.approximate(), digits, [&] {
    return proven_rolling(*memories, Interval(half_length, working_bits()), digits);
  });
  return ConvergedNip(std::move(parts));
}

ConvergedNip converged_for_load(const data::ViscoelasticNip& nip, double load, int digits) {
  const NipTask task = task_of(nip, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const Sheet sheet = sheet_of(nip, digits);
  const std::optional<ProvenMemories> memories = proven_memories(nip);
  ConvergedNip::Parts parts = parts_of(nip, sheet, memories, digits);
  const WorkingDigits working(parts.working_digits());
  const Exact wanted(mpq_class(load) / parts.units.force);
  const auto softness = [&](double half_length) {
    double sum = 1;
    for (const RollingMemory& term : sheet->material.normal)
      sum += static_cast<double>((term.amplitude / (term.rate + ComplexFloat(1 / half_length))).re);
    return sum;
  };
  parts.solved = task.solved_for_load(sheet, load, to_float(wanted),
                                      guessed_half_length(wanted.approximate(), softness));
  const NipSolution& fine = parts.solved->fine();
  parts.proof = proof_of(memories, static_cast<double>(fine.half_length()), digits, [&] {
    return proven_rolling_for_load(*memories, wanted, at_working_precision(fine.half_length()), fine.growth(),
                                   digits);
  });
  return ConvergedNip(std::move(parts));
}

}  // namespace nipref::ref
