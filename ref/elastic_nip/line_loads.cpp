#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/internal/thesis_creep.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/number/internal/enclosed_system.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/sheet/internal/kernel_over.hpp>
#include <nipref/ref/sheet/plain_series.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// Beyond those asked for: a system that needs more counts as singular.
constexpr int most_extra_digits = 400;
/// For what is computed from the unknowns.
constexpr int spare_digits = 4;

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

/// All lengths within `spread` of a length, relative.
struct Lengths {
  Float length;
  Float spread = 0;

  [[nodiscard]] Interval interval() const {
    return interval_of(length).widened(interval_of(abs(length) * spread));
  }
};

/// What all of these lengths have: unknowns, d0, the normal loads times N/pi and the shear loads times N/pi.
struct Contact {
  Interval length;
  std::vector<Interval> unknowns;
  std::optional<Interval> creep;
  Float error;      ///< largest of an unknown
  Float largest;    ///< unknown
  Float condition;  ///< of the matrix
};

/// Half an element over half a sheet, of all lengths.
Interval spacing(const Problem& problem, const Lengths& lengths) {
  const mpfr_prec_t precision = working_bits();
  return lengths.interval() / (4L * problem.elements()) /
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
  const Float poisson = problem.nip.material.poisson;
  for (Float& value : coupling.values) value -= (1 - 2 * poisson) / (2 * (1 - poisson)) * pi() / 2;
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

Contact contact_of(const Lengths& lengths, EnclosedSolutions solved) {
  return {lengths.interval(), std::move(solved.unknowns.front()), {}, solved.error, solved.largest,
          solved.condition};
}

/// Nothing if the precision does not suffice to prove a bound, or which creep is the thesis's.
std::optional<Contact> solve(const Problem& problem, const Lengths& lengths, int digits) {
  if (!problem.grips()) {
    auto solved = enclosed_solutions(
        frictionless_system(problem, lengths, evaluate(problem, lengths, SheetKernel::I1, digits)));
    return solved ? std::optional(contact_of(lengths, *std::move(solved))) : std::nullopt;
  }
  auto solved = enclosed_solutions(gripped_system(problem, lengths, digits));
  if (!solved) return std::nullopt;
  const std::vector<Interval> at_zero = solved->unknowns.front(), per_creep = solved->unknowns.back();
  const std::optional<Interval> creep =
      problem.grip.kind == Grip::Creep::given
          ? Interval(problem.grip.creep, working_bits())
          : thesis_creep({at_zero.begin() + 1, at_zero.end()}, {per_creep.begin() + 1, per_creep.end()});
  if (!creep) return std::nullopt;
  Contact contact = contact_of(lengths, *std::move(solved));
  contact.creep = creep;
  contact.error = contact.largest = 0;
  for (std::size_t i = 0; i < at_zero.size(); ++i) {
    contact.unknowns[i] = at_zero[i] + *creep * per_creep[i];
    const Float middle = middle_of(contact.unknowns[i]);
    contact.largest = std::max<Float>(contact.largest, abs(middle));
    contact.error = std::max<Float>(contact.error, upper_end(distance_from(middle, contact.unknowns[i])));
  }
  return contact;
}

/// pi/N.
Interval load_unit(const Problem& problem) {
  const mpfr_prec_t precision = working_bits();
  const Interval poisson(problem.nip.material.poisson, precision);
  return Interval::pi(precision) * Interval(problem.nip.material.young, precision) /
         (2 * (1 - poisson) * (poisson + 1L));
}

Interval load_of(const Problem& problem, const Contact& contact) {
  Interval sum(working_bits());
  for (int k = 1; k <= problem.elements(); ++k) sum = sum + contact.unknowns[static_cast<std::size_t>(k)];
  return 2 * (load_unit(problem) * sum);
}

Interval larger_of(const Interval& a, const Interval& b) {
  Interval result = a;
  if (mpfr_greater_p(b.lower(), a.lower()) != 0) mpfr_set(&result.get()->left, b.lower(), MPFR_RNDD);
  if (mpfr_greater_p(b.upper(), a.upper()) != 0) mpfr_set(&result.get()->right, b.upper(), MPFR_RNDU);
  return result;
}

LineLoadSolution solution_of(const Problem& problem, const Contact& contact, int digits) {
  const int m = problem.elements();
  const mpfr_prec_t precision = working_bits();
  const Interval unit = load_unit(problem), width = contact.length / (2L * m), &d0 = contact.unknowns.front();
  const Interval edge_gap = square(contact.length) / (8 * Interval(problem.nip.roller_radius, precision));
  const auto enclosed = [&](const Interval& interval) { return enclosure_of(interval, digits); };
  std::vector<Enclosure> normal, shear;
  std::optional<Interval> peak;
  Interval peak_shear(precision);
  for (std::size_t k = 1; k < contact.unknowns.size(); ++k) {
    const Interval force = unit * contact.unknowns[k];
    const bool is_normal = k <= static_cast<std::size_t>(m);
    (is_normal ? normal : shear).push_back(enclosed(force));
    if (is_normal) peak = peak ? larger_of(*peak, force) : force;
    if (!is_normal) peak_shear = larger_of(peak_shear, larger_of(force, -force));
  }
  return {enclosed(contact.length),
          enclosed(d0),
          enclosed(d0 - edge_gap),
          enclosed(load_of(problem, contact)),
          enclosed(*peak / width),
          enclosed(peak_shear / width),
          normal,
          shear,
          contact.creep ? std::optional(enclosed(*contact.creep)) : std::nullopt,
          static_cast<double>(contact.condition)};
}

/// Tries with more and more digits until the bounds are small enough; nothing if most_extra_digits do not prove
/// that. contact_at(digits beyond).
template <class ContactAt>
std::optional<LineLoadSolution> solve_to(const Problem& problem, int digits, ContactAt contact_at) {
  for (int extra = 15; extra <= most_extra_digits; extra += extra + 10) {
    const WorkingDigits working(digits + extra);
    const std::optional<Contact> contact = contact_at(extra);
    if (contact && contact->error <= pow(Float(10), -(digits + spare_digits)) * contact->largest)
      return solution_of(problem, *contact, digits);
  }
  return std::nullopt;
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

/// Of the kernels, for a first length.
constexpr int starting_digits = 16;

/// By secants of ln W over ln L from `length` until W is within 10^-digits of the load; nothing where that does
/// not lead there.
std::optional<Float> length_for_load(const Problem& problem, Float length, double load, int digits,
                                     int kernel_digits) {
  constexpr int most_tries = 60;
  constexpr double usual_exponent = 3, least_exponent = 1, longest_step = 2;
  const Float longest = longest_length * Float(problem.nip.sheet_thickness);
  const Float tolerance = pow(Float(10), -digits);
  Float exponent = usual_exponent, last_log = 0, last_excess = 0;
  for (int step = 0; step < most_tries; ++step) {
    const std::optional<Contact> tried = solve(problem, {length}, kernel_digits);
    if (!tried) return std::nullopt;
    const Float found = middle_of(load_of(problem, *tried));
    if (!(found > Float(0))) return std::nullopt;
    const Float excess = log(found / Float(load)), log_length = log(length);
    if (abs(excess) <= tolerance) return length;
    if (step > 0 && log_length != last_log) {
      exponent = std::max<Float>((excess - last_excess) / (log_length - last_log), least_exponent);
    }
    last_log = log_length;
    last_excess = excess;
    const Float change = std::clamp<Float>(-excess / exponent, -longest_step, longest_step);
    length = std::min<Float>(exp(log_length + change), longest);
  }
  return std::nullopt;
}

/// Whether W - load has different signs at the two ends of the lengths.
bool encloses_load(const Problem& problem, const Lengths& lengths, double load, int kernel_digits) {
  const Interval wanted(load, working_bits());
  const auto sign_at = [&](const Float& length) {
    const std::optional<Contact> contact = solve(problem, {length}, kernel_digits);
    if (!contact) return 0;
    const Interval excess = load_of(problem, *contact) - wanted;
    if (mpfr_sgn(excess.lower()) > 0) return 1;
    return mpfr_sgn(excess.upper()) < 0 ? -1 : 0;
  };
  const Float change = lengths.length * lengths.spread * (1 - Float(1e-3));
  return sign_at(lengths.length - change) * sign_at(lengths.length + change) < 0;
}

}  // namespace

LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, const LineLoadMethod& method,
                                       double contact_length, int digits, const Grip& grip) {
  const Problem problem{nip, method, grip};
  check(problem, contact_length, digits);
  auto solution = solve_to(problem, digits, [&](int extra) {
    return solve(problem, {Float(contact_length)}, digits + extra - 3);
  });
  if (solution) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 grip.kind == Grip::Creep::thesis
                     ? "must be one for which some creep meets the thesis's conditions: or give a creep"
                     : "must be one whose system is farther from singular than the reference can tell");
}

LineLoadSolution line_loads_for_load(const data::ElasticNip& nip, const LineLoadMethod& method, double load,
                                     int digits, const Grip& grip) {
  const Problem problem{nip, method, grip}, frictionless{nip, method, {}};
  check_digits_and_elements(problem, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  std::optional<Float> start;
  auto solution = solve_to(problem, digits, [&](int extra) -> std::optional<Contact> {
    const int kernel_digits = digits + extra - 3;
    if (!start) start = length_for_load(frictionless, Float(nip.sheet_thickness), load, 3, starting_digits);
    if (!start) return std::nullopt;
    // The load's own error is far below what it changes by over the spread.
    const auto length = length_for_load(problem, *start, load, digits + extra / 2 + 3, kernel_digits);
    if (!length) return std::nullopt;
    start = length;
    const Lengths lengths{*length, pow(Float(10), -(digits + extra / 2))};
    if (!encloses_load(problem, lengths, load, kernel_digits)) return std::nullopt;
    return solve(problem, lengths, kernel_digits);
  });
  if (solution) return *std::move(solution);
  throw BadInput("load", load, "no contact length was found that carries it");
}

CreepRange creep_range(const data::ElasticNip& nip, const LineLoadSolution& solution,
                       const LineLoadMethod& method, int digits) {
  const Problem problem{nip, method, {Grip::Creep::thesis}};
  for (int extra = 15; extra <= most_extra_digits; extra += extra + 10) {
    const WorkingDigits working(digits + extra);
    const Interval length = interval_of(solution.contact_length);
    const Float middle = middle_of(length), spread = upper_end(distance_from(middle, length)) / middle;
    const auto solved = enclosed_solutions(gripped_system(problem, {middle, spread}, digits + extra - 3));
    if (!solved) continue;
    const auto &at_zero = solved->unknowns.front(), &per_creep = solved->unknowns.back();
    const auto range =
        thesis_creep_range({at_zero.begin() + 1, at_zero.end()}, {per_creep.begin() + 1, per_creep.end()});
    if (!range) continue;
    return {enclosure_of(range->lower, digits), enclosure_of(range->upper, digits),
            enclosure_of(range->chosen, digits)};
  }
  throw BadInput("contact_length", solution.contact_length.to_double(),
                 "must be one for which some creep meets the thesis's conditions, and the bounds tell which");
}

LineLoadSolution line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                               double contact_length, int digits) {
  const Problem problem{nip, static_cast<int>(kernel.size() / 2), {}};
  check(problem, contact_length, digits);
  if (kernel.size() % 2 != 0) {
    throw BadInput("kernel", std::to_string(kernel.size()) + " values", "must have 2m values");
  }
  for (const double value : kernel) {
    if (!std::isfinite(value)) throw BadInput("kernel", value, "must be finite");
  }
  auto solution = solve_to(problem, digits, [&](int) -> std::optional<Contact> {
    const Lengths lengths{Float(contact_length)};
    auto solved = enclosed_solutions(
        frictionless_system(problem, lengths, {std::vector<Float>(kernel.begin(), kernel.end()), 0}));
    if (!solved) return std::nullopt;
    return contact_of(lengths, *std::move(solved));
  });
  if (!solution) {
    throw BadInput("kernel", kernel.front(),
                   "must be values that make no singular system (this is the first)");
  }
  return *std::move(solution);
}

}  // namespace nipref::ref
