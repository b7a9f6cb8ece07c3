#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/nip/internal/thesis_creep.hpp>
#include <nipref/ref/number/internal/enclosed_system.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/kernel_over.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;
using data::Grip;

/// A system that needs more counts as singular.
constexpr ExtraDigits extra_digits{12, 400};

/// Values of a kernel at the odd multiples 1, 3 .. 4m - 1 of a/b, and a bound on the error of each.
struct KernelValues {
  std::vector<Float> values;
  Float error = 0;

  [[nodiscard]] const Float& at(int odd_multiple) const {
    return values[static_cast<std::size_t>(odd_multiple / 2)];
  }
};

struct Problem {
  const data::ElasticNip& nip;
  LineLoadMethod method;
  Grip grip;

  [[nodiscard]] bool grips() const { return grip.kind != Grip::Creep::none; }
  [[nodiscard]] int elements() const { return method.elements_per_side; }
};

Interval interval_over(const Lengths& lengths) {
  return interval_of(lengths.length).widened(interval_of(abs(lengths.length) * lengths.spread));
}

/// N = theta1 + theta2.
Interval compliance_of(const data::ElasticNip& nip) {
  const mpfr_prec_t precision = working_bits();
  const Interval poisson(nip.material.poisson, precision);
  return 2 * (1 - poisson) * (poisson + 1L) / Interval(nip.material.young, precision);
}

/// theta2/N I2 of a positive distance.
Interval theta2_part(const data::ElasticNip& nip) {
  const Interval poisson(nip.material.poisson, working_bits());
  return (1 - 2 * poisson) / (4 * (1 - poisson)) * Interval::pi(working_bits());
}

/// Half an element over half a sheet, of all lengths.
Interval spacing(const Problem& problem, const Lengths& lengths) {
  const mpfr_prec_t precision = working_bits();
  return interval_over(lengths) / (4L * problem.elements()) /
         (Interval(problem.nip.sheet_thickness, precision) / 2L);
}

KernelValues evaluate(const Problem& problem, const Lengths& lengths, SheetKernel kernel, int digits) {
  const Interval unit = spacing(problem, lengths);
  KernelValues result;
  for (int q = 0; q < 2 * problem.elements(); ++q) {
    const Interval value = kernel_over(kernel, (2L * q + 1) * unit, problem.method.residue_terms, digits);
    result.values.push_back(middle_of(value));
    // Sums and differences of two values and a constant of order 1 round a few times.
    const Float rounding = 8 * (2 + abs(result.values.back())) * std::numeric_limits<Float>::epsilon();
    result.error =
        std::max<Float>(result.error, upper_end(distance_from(result.values.back(), value)) + rounding);
  }
  return result;
}

/// Unknowns: d0, then the normal loads. Rows: the normal displacement at 2 i a, i = 0 .. m.
NearlyKnownSystem frictionless_system(const Problem& problem, const Lengths& lengths,
                                      const KernelValues& I1_values) {
  const int m = problem.elements();
  NearlyKnownSystem system{Matrix(m + 1, m + 1), Matrix(m + 1, 1), 2 * I1_values.error, Vector(1)};
  for (int i = 0; i <= m; ++i) {
    const Float y = i * lengths.length / (2 * m);
    system.right(i) = y * y / (2 * Float(problem.nip.roller_radius));
    system.matrix(i, 0) = 1;
    for (int k = 1; k <= m; ++k) {
      system.matrix(i, k) = -(I1_values.at(std::abs(2 * (i - k) + 1)) + I1_values.at(2 * (i + k) - 1));
    }
  }
  system.right_error(0) = 3 * lengths.spread * system.right(m);
  return system;
}

/// The same with the shear loads as further unknowns and v = creep Y at i = 1 .. m as further rows; the right-hand
/// sides of creep 0 and of creep 1 on an undeformed roller.
NearlyKnownSystem gripped_system(const Problem& problem, const Lengths& lengths, int digits) {
  const int m = problem.elements();
  const KernelValues normal = evaluate(problem, lengths, SheetKernel::I1, digits);
  const KernelValues tangential = evaluate(problem, lengths, SheetKernel::I6, digits);
  KernelValues coupling = evaluate(problem, lengths, SheetKernel::I3, digits);
  const Float part = middle_of(theta2_part(problem.nip));
  for (Float& value : coupling.values) value -= part;
  const auto coupling_at = [&](int multiple) {
    return multiple > 0 ? coupling.at(multiple) : Float(-coupling.at(-multiple));
  };
  const NearlyKnownSystem above = frictionless_system(problem, lengths, normal);
  NearlyKnownSystem system{Matrix(2 * m + 1, 2 * m + 1), Matrix(2 * m + 1, 2),
                           2 * std::max({normal.error, coupling.error, tangential.error}), Vector(2)};
  system.matrix.topLeftCorner(above.matrix.rows(), above.matrix.cols()) = above.matrix;
  system.right.topLeftCorner(above.right.rows(), above.right.cols()) = above.right;
  for (int i = 0; i <= m; ++i) {
    for (int k = 1; k <= m; ++k) {
      const int near = 2 * (i - k) + 1, far = 2 * (i + k) - 1;
      system.matrix(i, m + k) = coupling_at(near) - coupling_at(far);
      if (i == 0) continue;
      system.matrix(m + i, k) = coupling_at(near) + coupling_at(far);
      system.matrix(m + i, m + k) = tangential.at(std::abs(near)) - tangential.at(far);
    }
    if (i > 0) system.right(m + i, 1) = i * lengths.length / (2 * m);
  }
  system.right_error(0) = above.right_error(0);
  system.right_error(1) = 2 * lengths.spread * lengths.length;
  return system;
}

/// N/pi I1 and N/pi (I3 - theta2/N I2) of a normal load, N/pi I6 and minus the latter of a shear load.
class LoadedSheet final : public LineLoadSheet {
 public:
  LoadedSheet(const data::ElasticNip& nip, int residue_terms, int digits)
      : nip_(nip), residue_terms_(residue_terms), digits_(digits) {}

  [[nodiscard]] Interval normal_displacement(const SolvedLineLoads& loads, std::size_t load,
                                             const LineLoadPlace& place) const override {
    const Interval alpha = distance(loads, load, place);
    const Interval pressed = loads.normal[load] * kernel(SheetKernel::I1, alpha);
    return scale() * (loads.shear.empty() ? pressed : pressed - loads.shear[load] * coupling(alpha));
  }
  [[nodiscard]] Interval tangential_displacement(const SolvedLineLoads& loads, std::size_t load,
                                                 const LineLoadPlace& place) const override {
    const Interval alpha = distance(loads, load, place), pressed = loads.normal[load] * coupling(alpha);
    if (loads.shear.empty()) return scale() * pressed;
    return scale() * (pressed + loads.shear[load] * kernel(SheetKernel::I6, alpha));
  }

 private:
  [[nodiscard]] Interval scale() const { return compliance_of(nip_) / Interval::pi(working_bits()); }
  /// In half-thicknesses.
  [[nodiscard]] Interval distance(const SolvedLineLoads& loads, std::size_t load,
                                  const LineLoadPlace& place) const {
    return 2 * loads.distance(load, place) / Interval(nip_.sheet_thickness, working_bits());
  }
  [[nodiscard]] Interval kernel(SheetKernel which, const Interval& alpha) const {
    return kernel_over(which, alpha, residue_terms_, digits_);
  }
  [[nodiscard]] Interval coupling(const Interval& alpha) const {
    const Interval part = theta2_part(nip_);
    return kernel(SheetKernel::I3, alpha) - (mpfr_sgn(alpha.upper()) < 0 ? -part : part);
  }

  data::ElasticNip nip_;
  int residue_terms_, digits_;
};

/// The loads of both sides, from those of one times N/pi.
std::vector<Interval> both_sides(const Interval& unit, std::span<const Interval> side, long sign) {
  std::vector<Interval> loads;
  for (std::size_t k = side.size(); k-- > 0;) loads.push_back(unit * side[k]);
  for (const Interval& load : side) loads.push_back(sign * (unit * load));
  return loads;
}

SolvedLineLoads contact_of(const Problem& problem, const Lengths& lengths, const EnclosedSolutions& solved,
                           const std::vector<Interval>& unknowns, int digits) {
  const auto m = static_cast<std::size_t>(problem.elements());
  const Interval unit = Interval::pi(working_bits()) / compliance_of(problem.nip);
  const std::span loads = std::span(unknowns).subspan(1);
  return {.roller_radius = problem.nip.roller_radius,
          .leading_elements = problem.elements(),
          .is_symmetric = true,
          .contact_length = interval_over(lengths),
          .indentation = unknowns.front(),
          .normal = both_sides(unit, loads.first(m), 1),
          .shear = both_sides(unit, loads.subspan(m), -1),
          .error = solved.error / solved.largest,
          .condition = solved.condition,
          .unknowns = static_cast<int>(unknowns.size()),
          .sheet = std::make_shared<const LoadedSheet>(problem.nip, problem.method.residue_terms, digits)};
}

/// Nothing if the precision does not suffice to prove a bound, or which creep is the thesis's.
std::optional<SolvedLineLoads> solve(const Problem& problem, const Lengths& lengths, int digits) {
  if (!problem.grips()) {
    const auto solved = enclosed_solutions(
        frictionless_system(problem, lengths, evaluate(problem, lengths, SheetKernel::I1, digits)));
    if (!solved) return std::nullopt;
    return contact_of(problem, lengths, *solved, solved->unknowns.front(), digits);
  }
  auto solved = enclosed_solutions(gripped_system(problem, lengths, digits));
  if (!solved) return std::nullopt;
  const std::vector<Interval>&at_zero = solved->unknowns.front(), &per_creep = solved->unknowns.back();
  const std::vector<Interval> loads_at_zero(at_zero.begin() + 1, at_zero.end()),
      loads_per_creep(per_creep.begin() + 1, per_creep.end());
  const std::optional<Interval> creep = problem.grip.kind == Grip::Creep::given
                                            ? Interval(problem.grip.creep, working_bits())
                                            : thesis_creep(loads_at_zero, loads_per_creep);
  if (!creep) return std::nullopt;
  std::vector<Interval> unknowns;
  solved->error = solved->largest = 0;
  for (std::size_t i = 0; i < at_zero.size(); ++i) {
    unknowns.push_back(at_zero[i] + *creep * per_creep[i]);
    const Float middle = middle_of(unknowns[i]);
    solved->largest = std::max<Float>(solved->largest, abs(middle));
    solved->error = std::max<Float>(solved->error, upper_end(distance_from(middle, unknowns[i])));
  }
  SolvedLineLoads contact = contact_of(problem, lengths, *solved, unknowns, digits);
  contact.gripped_creep = creep;
  contact.at_zero = loads_at_zero;
  contact.per_creep = loads_per_creep;
  return contact;
}

void check_digits_and_elements(const Problem& problem, int digits) {
  problem.nip.check();
  const auto [elements, terms] = problem.method;
  if (elements < 1 || elements > 200)
    throw BadInput("elements_per_side", std::to_string(elements), "must be from 1 to 200 in the reference");
  if (terms < 0 || terms > most_residue_terms)
    throw BadInput("residue_terms", std::to_string(terms),
                   "must be from 0 to " + std::to_string(most_residue_terms));
  if (digits < 16 || digits > 300) throw BadInput("digits", std::to_string(digits), "must be from 16 to 300");
  if (!std::isfinite(problem.grip.creep)) throw BadInput("creep", problem.grip.creep, "must be finite");
}

/// Farther loads than the reference kernels reach do not occur within 1000 half-thicknesses.
constexpr double longest_length = 500;

void check(const Problem& problem, double contact_length, int digits) {
  check_digits_and_elements(problem, digits);
  if (!(contact_length > 0 && contact_length / problem.nip.sheet_thickness <= longest_length)) {
    throw BadInput("contact_length", contact_length,
                   "must be > 0 and at most 500 sheet thicknesses in the reference");
  }
}

}  // namespace

LineLoadNip line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                  double contact_length, int digits, const data::Grip& grip) {
  const Problem problem{nip, method, grip};
  check(problem, contact_length, digits);
  auto solution = solved_to(digits, extra_digits, [&](int kernel_digits) {
    return solve(problem, {Float(contact_length)}, kernel_digits);
  });
  if (solution) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 grip.kind == Grip::Creep::thesis
                     ? "must be one for which some creep meets the thesis's conditions: or give a creep"
                     : "must be one whose system is farther from singular than the reference can tell");
}

LineLoadNip line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                int digits, const data::Grip& grip) {
  constexpr int starting_digits = 16, starting_tolerance = 3;  // without friction
  const Problem problem{nip, method, grip}, frictionless{nip, method, {}};
  check_digits_and_elements(problem, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  LengthSearch search{load, longest_length * Float(nip.sheet_thickness), Float(nip.sheet_thickness)};
  const auto by = [](const Problem& given, int kernel_digits) {
    return [&given, kernel_digits](const Lengths& lengths) { return solve(given, lengths, kernel_digits); };
  };
  bool has_start = false;
  auto solution = solved_to(digits, extra_digits, [&](int kernel_digits) -> std::optional<SolvedLineLoads> {
    if (!has_start) has_start = search.seek(starting_tolerance, by(frictionless, starting_digits));
    if (!has_start) return std::nullopt;
    return search.contact_carrying((digits + kernel_digits) / 2, by(problem, kernel_digits));
  });
  if (solution) return *std::move(solution);
  throw BadInput("load", load, "no contact length was found that carries it");
}

LineLoadNip line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                          double contact_length, int digits) {
  const Problem problem{nip, static_cast<int>(kernel.size() / 2), {}};
  check(problem, contact_length, digits);
  if (kernel.size() % 2 != 0) {
    throw BadInput("kernel", std::to_string(kernel.size()) + " values", "must have 2m values");
  }
  for (const double value : kernel) {
    if (!std::isfinite(value)) throw BadInput("kernel", value, "must be finite");
  }
  auto solution = solved_to(digits, extra_digits, [&](int kernel_digits) -> std::optional<SolvedLineLoads> {
    const Lengths lengths{Float(contact_length)};
    const auto solved = enclosed_solutions(
        frictionless_system(problem, lengths, {std::vector<Float>(kernel.begin(), kernel.end()), 0}));
    if (!solved) return std::nullopt;
    return contact_of(problem, lengths, *solved, solved->unknowns.front(), kernel_digits);
  });
  if (!solution) {
    throw BadInput("kernel", kernel.front(),
                   "must be values that make no singular system (this is the first)");
  }
  return *std::move(solution);
}

}  // namespace nipref::ref
