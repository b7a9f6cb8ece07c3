#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/memory/moving_load.hpp>
#include <nipref/ref/number/internal/enclosed_system.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int guard_digits = 12, kernel_guard_digits = 8;
constexpr int most_elements = 100;
constexpr double farthest = 500;  ///< of the start, half-thicknesses

/// A nip, known exactly, its method with the number of trailing elements.
struct RollingLoads {
  data::ViscoelasticNip nip;
  ExactMaterial material;
  int leading, trailing;
  mpq_class approach;
  int residue_terms, digits;

  [[nodiscard]] int loads() const { return leading + trailing; }
  [[nodiscard]] mpq_class half_thickness() const { return mpq_class(nip.sheet_thickness) / 2; }
  [[nodiscard]] Float instantaneous() const { return to_float(Exact(material.normal().instantaneous)); }
  [[nodiscard]] int kernel_digits() const { return digits + kernel_guard_digits; }
  /// Of a way in half-thicknesses.
  [[nodiscard]] Exact time(const mpq_class& way) const {
    return Exact(mpq_class(way * half_thickness() / mpq_class(nip.speed)));
  }
};

/// Lengths in half-thicknesses. (thesis 7.11)
struct Grid {
  mpq_class element;  ///< half the width of an element
  mpq_class approach;
  int leading;

  [[nodiscard]] mpq_class t(int i) const { return 2 * i * element + approach; }
  [[nodiscard]] mpq_class T(int j) const { return (2 * j + 1) * element + approach; }
  /// Of a load from the line through the centres, towards the leading side.
  [[nodiscard]] mpq_class position(int j) const { return (2 * leading - 1 - 2 * j) * element; }
};

/// The contact of one leading length.
struct OneLength {
  Float leading_length;
  Grid grid;
  Interval indentation;         ///< over b
  std::vector<Interval> loads;  ///< times the instantaneous compliance over b
};

Interval of(const Estimated& number) {
  const mpfr_prec_t precision = std::max(number.value.precision(), precision_here()) + 64;
  return Interval(number.value, number.value, precision)
      .widened(Interval(number.error, number.error, precision));
}

Interval normal_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T) {
  return of(moving_load_normal_displacement(problem.time(t), problem.time(T), Exact(problem.nip.speed),
                                            Exact(problem.half_thickness()), problem.material,
                                            problem.kernel_digits(), problem.residue_terms));
}

Interval tangential_at(const RollingLoads& problem, const mpq_class& t, const mpq_class& T,
                       const mpq_class& t0) {
  return of(moving_load_tangential_displacement(
      problem.time(t), problem.time(T), problem.time(t0), Exact(problem.nip.speed),
      Exact(problem.half_thickness()), problem.material, problem.kernel_digits(), problem.residue_terms));
}

OneLength solve(const RollingLoads& problem, const Float& leading_length) {
  const mpq_class half_thickness = problem.half_thickness();
  const Grid grid{to_exact(leading_length).value() / (2 * problem.leading * half_thickness), problem.approach,
                  problem.leading};
  const int n = problem.loads();
  NearlyKnownSystem system{Matrix(n + 1, n + 1), Matrix(n + 1, 1), 0, {}};
  const Interval compliance = interval_of(problem.instantaneous());
  for (int i = 0; i <= n; ++i) {
    const Float y = to_float(Exact(mpq_class(2 * (problem.leading - i) * grid.element)));
    system.right(i) = y * y * to_float(Exact(half_thickness)) / (2 * Float(problem.nip.roller_radius));
    system.matrix(i, 0) = 1;
    for (int j = 0; j < n; ++j) {
      const Interval influence = -(normal_at(problem, grid.t(i), grid.T(j)) / compliance);
      system.matrix(i, j + 1) = middle_of(influence);
      system.error =
          std::max<Float>(system.error, upper_end(distance_from(system.matrix(i, j + 1), influence)));
    }
  }
  system.right_error = Vector(1);
  system.right_error(0) = 8 * std::numeric_limits<Float>::epsilon() * abs(system.right(0));
  auto solved = enclosed_solutions(system);
  if (!solved)
    throw BadInput("contact_length", static_cast<double>(leading_length),
                   "must be one whose system is farther from singular than the reference can tell");
  std::vector<Interval> unknowns = std::move(solved->unknowns.front());
  OneLength result{leading_length, grid, unknowns.front(), {unknowns.begin() + 1, unknowns.end()}};
  return result;
}

Interval half_thickness_of(const RollingLoads& problem) {
  return {Exact(problem.half_thickness()), precision_here()};
}

/// Force per unit width of what counts as OneLength::loads do.
Interval force_unit(const RollingLoads& problem) {
  return half_thickness_of(problem) / interval_of(problem.instantaneous());
}

Interval load_of(const RollingLoads& problem, const OneLength& contact) {
  Interval sum(precision_here());
  for (const Interval& load : contact.loads) sum = sum + load;
  return force_unit(problem) * sum;
}

}  // namespace

struct ViscoelasticLineLoads::Implementation {
  RollingLoads problem;
  OneLength last, before;  ///< the last lengths tried, the same where the length is given
  Float missing;           ///< of the load, over what it changed by in the last step
  int systems;

  using Function = std::function<Interval(const OneLength&)>;

  [[nodiscard]] Estimated of(const Function& function) const {
    const WorkingDigits scope(problem.digits + guard_digits);
    const Interval interval = function(last);
    const Float value = middle_of(interval);
    Float error = upper_end(distance_from(value, interval));
    if (missing > Float(0)) error += missing * abs(value - middle_of(function(before)));
    return {to_real(value), to_real(error), problem.digits};
  }
  [[nodiscard]] Interval length(const OneLength& contact, int elements) const {
    return static_cast<long>(elements) * interval_of(contact.leading_length) /
           static_cast<long>(problem.leading);
  }
  [[nodiscard]] Interval parabola(const Interval& y) const {
    return square(y) / (2 * Interval(problem.nip.roller_radius, precision_here()));
  }
  [[nodiscard]] Interval indentation(const OneLength& contact) const {
    return contact.indentation * half_thickness_of(problem);
  }
  [[nodiscard]] Interval element_width(const OneLength& contact) const {
    return interval_of(contact.leading_length) / static_cast<long>(problem.leading);
  }
  /// The sum of each load's displacement(t, T, t0) for the point that is at Y at the time t.
  template <class Displacement>
  [[nodiscard]] Interval sum(const OneLength& contact, const mpq_class& y,
                             const Displacement& displacement) const {
    const mpq_class at = y / problem.half_thickness();
    const mpq_class t = problem.approach + 2 * problem.leading * contact.grid.element - at;
    Interval total(precision_here());
    for (int j = 0; j < problem.loads(); ++j) {
      const mpq_class position = contact.grid.position(j);
      if (at == position) throw BadInput("y", Exact(y).approximate(), "must not be the place of a line load");
      total = total + contact.loads[static_cast<std::size_t>(j)] *
                          displacement(t, mpq_class(t + at - position), mpq_class(t - position));
    }
    return force_unit(problem) * total;
  }
  [[nodiscard]] Interval tangential(const OneLength& contact, const mpq_class& y) const {
    return sum(contact, y, [&](const mpq_class& t, const mpq_class& T, const mpq_class& t0) {
      return tangential_at(problem, t, T, t0);
    });
  }
  void check_place(double y) const {
    const double ahead = static_cast<double>(last.leading_length) +
                         Exact(problem.approach).approximate() * problem.nip.half_thickness();
    if (!(std::isfinite(y) && y <= ahead))
      throw BadInput("y", y, "must be finite, and not ahead of where the leading end started");
  }
};

namespace {

RollingLoads checked(const data::ViscoelasticNip& nip, const ViscoelasticLineLoadMethod& method, int digits) {
  nip.check();
  if (digits < 16 || digits > 30)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 30 with line loads that roll");
  const int trailing = method.trailing_elements.value_or(method.leading_elements);
  for (const auto& [name, elements, least] : {std::tuple("leading_elements", method.leading_elements, 1),
                                              std::tuple("trailing_elements", trailing, 0)}) {
    if (elements < least || elements > most_elements)
      throw BadInput(name, std::to_string(elements),
                     "must be from " + std::to_string(least) + " to " + std::to_string(most_elements) +
                         " in the reference");
  }
  if (!(method.approach > 0 && method.approach <= farthest))
    throw BadInput("approach_lengths", method.approach, "must be > 0 and at most 500 in the reference");
  if (method.residue_terms < 0 || method.residue_terms > 500)
    throw BadInput("residue_terms", std::to_string(method.residue_terms), "must be from 0 to 500");
  return {nip,      exact_material(nip.material), method.leading_elements,
          trailing, mpq_class(method.approach),   method.residue_terms,
          digits};
}

/// Two lengths next to the one that carries a load, and how far the last is from it.
struct Search {
  OneLength last, before;
  Float missing;
  int systems;
};

/// By secants of ln W over ln L1 from `length` until W is within 10^-digits of the load.
Search search_length(const RollingLoads& problem, Float length, double load, int digits) {
  constexpr int most_steps = 40;
  constexpr double usual_exponent = 3, least_exponent = 1, longest_step = 1;
  const Float tolerance = pow(Float(10), -digits), longest = problem.nip.roller_radius;
  std::optional<OneLength> before;
  Float exponent = usual_exponent, last_log = 0, last_excess = 0, last_found = 0;
  for (int step = 0; step < most_steps; ++step) {
    OneLength tried = solve(problem, length);
    const Interval carried = load_of(problem, tried);
    const Float found = middle_of(carried);
    if (!(found > Float(0))) {
      length = length / 3;
      continue;
    }
    const Float excess = log(found / Float(load)), log_length = log(length);
    if (before && log_length != last_log) {
      if (abs(excess) <= tolerance) {
        const Float off = abs(found - Float(load)) + upper_end(distance_from(found, carried));
        const Float missing = 2 * off / abs(found - last_found);
        return {std::move(tried), *std::move(before), missing, step + 1};
      }
      exponent = std::max<Float>((excess - last_excess) / (log_length - last_log), least_exponent);
    }
    last_log = log_length;
    last_excess = excess;
    last_found = found;
    before = std::move(tried);
    // Never the same length twice: the last step tells how results go with the length.
    Float change = std::clamp<Float>(-excess / exponent, -longest_step, longest_step);
    if (abs(change) < tolerance) change = 10 * tolerance;
    length = std::min<Float>(exp(log_length + change), longest);
  }
  throw BadInput("load", load, "must be one that line loads on a length below the roller's radius can carry");
}

bool presses_everywhere(const OneLength& contact) {
  return std::ranges::all_of(contact.loads, [](const Interval& load) { return middle_of(load) >= Float(0); });
}

}  // namespace

ViscoelasticLineLoads ViscoelasticLineLoads::for_length(const data::ViscoelasticNip& nip,
                                                        const ViscoelasticLineLoadMethod& method,
                                                        double contact_length, int digits) {
  const RollingLoads problem = checked(nip, method, digits);
  if (!(contact_length > 0 && contact_length <= nip.roller_radius))
    throw BadInput("contact_length", contact_length, "must be > 0 and at most the roller's radius");
  const WorkingDigits scope(digits + guard_digits);
  const OneLength contact = solve(problem, Float(contact_length) * problem.leading / problem.loads());
  return ViscoelasticLineLoads(
      std::make_shared<const Implementation>(Implementation{problem, contact, contact, 0, 1}));
}

ViscoelasticLineLoads ViscoelasticLineLoads::for_load(const data::ViscoelasticNip& nip,
                                                      const ViscoelasticLineLoadMethod& method, double load,
                                                      int digits) {
  // Enough to see whether a load pulls, and to go on from.
  constexpr int first_digits = 16, first_agreement = 5;
  RollingLoads problem = checked(nip, method, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const WorkingDigits scope(digits + guard_digits);
  Float length = sqrt(Float(load) * Float(nip.roller_radius) * problem.instantaneous());
  int systems = 0;
  problem.digits = first_digits;
  while (true) {
    const Search first = search_length(problem, length, load, first_agreement);
    systems += first.systems;
    length = first.last.leading_length;
    if (method.trailing_elements || problem.trailing == 0 || presses_everywhere(first.last)) break;
    --problem.trailing;
  }
  problem.digits = digits;
  Search found = search_length(problem, length, load, digits + 2);
  return ViscoelasticLineLoads(std::make_shared<const Implementation>(Implementation{
      problem, std::move(found.last), std::move(found.before), found.missing, systems + found.systems}));
}

Estimated ViscoelasticLineLoads::contact_length() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) { return all.length(contact, all.problem.loads()); });
}

Estimated ViscoelasticLineLoads::leading_length() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) { return all.length(contact, all.problem.leading); });
}

Estimated ViscoelasticLineLoads::trailing_length() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) { return all.length(contact, all.problem.trailing); });
}

Estimated ViscoelasticLineLoads::indentation() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) { return all.indentation(contact); });
}

Estimated ViscoelasticLineLoads::leading_displacement() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) {
    return all.indentation(contact) - all.parabola(all.length(contact, all.problem.leading));
  });
}

Estimated ViscoelasticLineLoads::trailing_displacement() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) {
    return all.indentation(contact) - all.parabola(all.length(contact, all.problem.trailing));
  });
}

Estimated ViscoelasticLineLoads::load() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) { return load_of(all.problem, contact); });
}

Estimated ViscoelasticLineLoads::peak_pressure() const {
  const auto& all = *implementation_;
  // The same load for both lengths.
  const auto& loads = all.last.loads;
  const auto peak = std::ranges::max_element(
      loads, [](const Interval& a, const Interval& b) { return middle_of(a) < middle_of(b); });
  const auto index = static_cast<std::size_t>(peak - loads.begin());
  return all.of([&](const OneLength& contact) {
    return force_unit(all.problem) * contact.loads[index] / all.element_width(contact);
  });
}

Estimated ViscoelasticLineLoads::rolling_resistance() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) {
    Interval moment(precision_here());
    for (int j = 0; j < all.problem.loads(); ++j)
      moment = moment + contact.loads[static_cast<std::size_t>(j)] *
                            Interval(Exact(contact.grid.position(j)), precision_here());
    moment = moment * half_thickness_of(all.problem) * force_unit(all.problem);
    return moment /
           (load_of(all.problem, contact) * Interval(all.problem.nip.roller_radius, precision_here()));
  });
}

Estimated ViscoelasticLineLoads::creep_ratio() const {
  const auto& all = *implementation_;
  return all.of([&](const OneLength& contact) {
    const mpq_class leading = to_exact(contact.leading_length).value();
    const mpq_class trailing = -leading * all.problem.trailing / all.problem.leading;
    return (all.tangential(contact, leading) - all.tangential(contact, trailing)) /
           all.length(contact, all.problem.loads());
  });
}

Estimated ViscoelasticLineLoads::pressure(double y) const {
  const auto& all = *implementation_;
  const double leading = static_cast<double>(all.last.leading_length);
  const double width = leading / all.problem.leading, border = 0x1p-50 * leading;
  const double ahead = leading - y;
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  if (ahead < -border || ahead > all.problem.loads() * width + border) return exact_zero(all.problem.digits);
  const auto element = static_cast<std::size_t>(std::max(0.0, ahead + border) / width);
  return all.of([&](const OneLength& contact) {
    return force_unit(all.problem) * contact.loads[std::min(element, contact.loads.size() - 1)] /
           all.element_width(contact);
  });
}

Estimated ViscoelasticLineLoads::normal_displacement(double y) const {
  const auto& all = *implementation_;
  all.check_place(y);
  return all.of([&](const OneLength& contact) {
    return all.sum(contact, mpq_class(y), [&](const mpq_class& t, const mpq_class& T, const mpq_class&) {
      return normal_at(all.problem, t, T);
    });
  });
}

Estimated ViscoelasticLineLoads::tangential_displacement(double y) const {
  const auto& all = *implementation_;
  all.check_place(y);
  return all.of([&](const OneLength& contact) {
    return all.tangential(contact, mpq_class(y)) - all.tangential(contact, mpq_class(0));
  });
}

int ViscoelasticLineLoads::systems() const { return implementation_->systems; }
int ViscoelasticLineLoads::elements() const { return implementation_->problem.loads(); }

}  // namespace nipref::ref
