#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int guard_digits = 12;
constexpr int most_elements = 100;
constexpr double farthest = 500;  ///< of the start, half-thicknesses

}  // namespace

struct ViscoelasticLineLoads::Implementation {
  RollingLoads problem;
  LoadsOnLength last, before;  ///< the last lengths tried, the same where the length is given
  Float missing;               ///< of the load, over what it changed by in the last step
  int systems;

  using Function = std::function<Interval(const LoadsOnLength&)>;

  [[nodiscard]] Estimate of(const Function& function) const {
    const WorkingDigits scope(problem.digits + guard_digits);
    const Interval interval = function(last);
    const Float value = middle_of(interval);
    Float error = upper_end(distance_from(value, interval));
    if (missing > Float(0)) error += missing * abs(value - middle_of(function(before)));
    return {value, error, problem.digits};
  }
  [[nodiscard]] Interval length(const LoadsOnLength& contact, int elements) const {
    return static_cast<long>(elements) * interval_of(contact.leading_length) /
           static_cast<long>(problem.leading);
  }
  [[nodiscard]] Interval parabola(const Interval& y) const {
    return square(y) / (2 * Interval(problem.nip.roller_radius, working_bits()));
  }
  [[nodiscard]] std::size_t largest_load() const {
    const auto largest = std::ranges::max_element(
        last.loads, [](const Interval& a, const Interval& b) { return middle_of(a) < middle_of(b); });
    return static_cast<std::size_t>(largest - last.loads.begin());
  }
  [[nodiscard]] Interval indentation(const LoadsOnLength& contact) const {
    return contact.indentation * half_thickness_of(problem);
  }
  [[nodiscard]] Interval element_width(const LoadsOnLength& contact) const {
    return interval_of(contact.leading_length) / static_cast<long>(problem.leading);
  }
  /// Of the loads `counted` by their positions, in force.
  template <class Counted>
  [[nodiscard]] Interval moment(const LoadsOnLength& contact, const Counted& counted) const {
    Interval total(working_bits());
    for (int j = 0; j < problem.loads(); ++j) {
      const mpq_class position = contact.grid.position(j);
      if (counted(position))
        total =
            total + contact.loads[static_cast<std::size_t>(j)] * Interval(Exact(position), working_bits());
    }
    return total * half_thickness_of(problem) * force_unit(problem);
  }
  /// The sum of each load's displacement(t, T, t0) for the point that is at Y at the time t.
  template <class Displacement>
  [[nodiscard]] Interval sum(const LoadsOnLength& contact, const mpq_class& y,
                             const Displacement& displacement) const {
    const mpq_class at = y / problem.half_thickness();
    const mpq_class t = problem.approach + 2 * problem.leading * contact.grid.element - at;
    Interval total(working_bits());
    for (int j = 0; j < problem.loads(); ++j) {
      const mpq_class position = contact.grid.position(j);
      if (at == position) throw BadInput("y", Exact(y).approximate(), "must not be the place of a line load");
      total = total + contact.loads[static_cast<std::size_t>(j)] *
                          displacement(t, mpq_class(t + at - position), mpq_class(t - position));
    }
    return force_unit(problem) * total;
  }
  [[nodiscard]] Interval tangential(const LoadsOnLength& contact, const mpq_class& y) const {
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
  const ExactMaterial material = exact_material(nip.material, digits + guard_digits);
  if (method.residue_terms > 0 &&
      std::ranges::any_of(material.normal().terms, [](const auto& term) { return term.rate == 0; }))
    throw BadInput("residue_terms", std::to_string(method.residue_terms),
                   "must be 0: the material is a fluid, and the thesis's sums divide by its rate, 0");
  return {
      nip,   material, method.leading_elements, trailing, mpq_class(method.approach), method.residue_terms,
      digits};
}

}  // namespace

ViscoelasticLineLoads ViscoelasticLineLoads::for_length(const data::ViscoelasticNip& nip,
                                                        const ViscoelasticLineLoadMethod& method,
                                                        double contact_length, int digits) {
  const RollingLoads problem = checked(nip, method, digits);
  if (!(contact_length > 0 && contact_length <= nip.roller_radius))
    throw BadInput("contact_length", contact_length, "must be > 0 and at most the roller's radius");
  const WorkingDigits scope(digits + guard_digits);
  const LoadsOnLength contact =
      solve_loads(problem, Float(contact_length) * problem.leading / problem.loads());
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
    const FoundLength first = search_length(problem, length, load, first_agreement);
    systems += first.systems;
    length = first.last.leading_length;
    if (method.trailing_elements || problem.trailing == 0 || presses_everywhere(first.last)) break;
    --problem.trailing;
  }
  problem.digits = digits;
  FoundLength found = search_length(problem, length, load, digits + 2);
  return ViscoelasticLineLoads(std::make_shared<const Implementation>(Implementation{
      problem, std::move(found.last), std::move(found.before), found.missing, systems + found.systems}));
}

Estimate ViscoelasticLineLoads::contact_length() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) { return all.length(contact, all.problem.loads()); });
}

Estimate ViscoelasticLineLoads::leading_length() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) { return all.length(contact, all.problem.leading); });
}

Estimate ViscoelasticLineLoads::trailing_length() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) { return all.length(contact, all.problem.trailing); });
}

Estimate ViscoelasticLineLoads::indentation() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) { return all.indentation(contact); });
}

Estimate ViscoelasticLineLoads::leading_displacement() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    return all.indentation(contact) - all.parabola(all.length(contact, all.problem.leading));
  });
}

Estimate ViscoelasticLineLoads::trailing_displacement() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    return all.indentation(contact) - all.parabola(all.length(contact, all.problem.trailing));
  });
}

Estimate ViscoelasticLineLoads::load() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) { return load_of(all.problem, contact); });
}

Estimate ViscoelasticLineLoads::peak_pressure() const {
  const auto& all = *implementation_;
  // The same load for both lengths.
  const std::size_t index = all.largest_load();
  return all.of([&](const LoadsOnLength& contact) {
    return force_unit(all.problem) * contact.loads[index] / all.element_width(contact);
  });
}

Estimate ViscoelasticLineLoads::peak_pressure_position() const {
  const auto& all = *implementation_;
  const auto twice_before = 2 * static_cast<long>(all.largest_load()) + 1;
  return all.of([&](const LoadsOnLength& contact) {
    return interval_of(contact.leading_length) - twice_before * all.element_width(contact) / 2;
  });
}

Estimate ViscoelasticLineLoads::rolling_resistance() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    return all.moment(contact, [](const mpq_class&) { return true; }) /
           (load_of(all.problem, contact) * Interval(all.problem.nip.roller_radius, working_bits()));
  });
}

Estimate ViscoelasticLineLoads::leading_moment() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    return all.moment(contact, [](const mpq_class& position) { return position > 0; });
  });
}

Estimate ViscoelasticLineLoads::trailing_moment() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    return all.moment(contact, [](const mpq_class& position) { return position < 0; });
  });
}

Estimate ViscoelasticLineLoads::creep_ratio() const {
  const auto& all = *implementation_;
  return all.of([&](const LoadsOnLength& contact) {
    const mpq_class leading = to_exact(contact.leading_length).value();
    const mpq_class trailing = -leading * all.problem.trailing / all.problem.leading;
    return (all.tangential(contact, leading) - all.tangential(contact, trailing)) /
           all.length(contact, all.problem.loads());
  });
}

Estimate ViscoelasticLineLoads::pressure(double y) const {
  const auto& all = *implementation_;
  const double leading = static_cast<double>(all.last.leading_length);
  const double width = leading / all.problem.leading, border = 0x1p-50 * leading;
  const double ahead = leading - y;
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  if (ahead < -border || ahead > all.problem.loads() * width + border) return exact_zero(all.problem.digits);
  const auto element = static_cast<std::size_t>(std::max(0.0, ahead + border) / width);
  return all.of([&](const LoadsOnLength& contact) {
    return force_unit(all.problem) * contact.loads[std::min(element, contact.loads.size() - 1)] /
           all.element_width(contact);
  });
}

Estimate ViscoelasticLineLoads::normal_displacement(double y) const {
  const auto& all = *implementation_;
  all.check_place(y);
  return all.of([&](const LoadsOnLength& contact) {
    return all.sum(contact, mpq_class(y), [&](const mpq_class& t, const mpq_class& T, const mpq_class&) {
      return normal_at(all.problem, t, T);
    });
  });
}

Estimate ViscoelasticLineLoads::tangential_displacement(double y) const {
  const auto& all = *implementation_;
  all.check_place(y);
  return all.of([&](const LoadsOnLength& contact) {
    return all.tangential(contact, mpq_class(y)) - all.tangential(contact, mpq_class(0));
  });
}

int ViscoelasticLineLoads::systems() const { return implementation_->systems; }
int ViscoelasticLineLoads::elements() const { return implementation_->problem.loads(); }

}  // namespace nipref::ref
