#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/material/internal/material_compliances.hpp>
#include <nipref/ref/viscoelastic_nip/internal/rolling_loads.hpp>
#include <nipref/ref/viscoelastic_nip/line_loads.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int most_elements = 100;
constexpr double farthest = 500;  ///< of the start, half-thicknesses

/// Digits beyond those asked for, of influences and arithmetic; more where these do not suffice.
constexpr int first_extra_digits = 24, most_extra_digits = 100, spare_digits = 4, rounding_digits = 6;

Interval larger_of(const Interval& a, const Interval& b) {
  Interval result = a;
  if (mpfr_greater_p(b.lower(), a.lower()) != 0) mpfr_set(&result.get()->left, b.lower(), MPFR_RNDD);
  if (mpfr_greater_p(b.upper(), a.upper()) != 0) mpfr_set(&result.get()->right, b.upper(), MPFR_RNDU);
  return result;
}

}  // namespace

struct ViscoelasticLineLoads::Implementation {
  RollingLoads problem;
  LoadsOnLength contact;
  int digits, systems;
  bool length_is_given;

  template <class Function>
  [[nodiscard]] Enclosure enclosed(const Function& function) const {
    const WorkingDigits scope(problem.digits + rounding_digits);
    return enclosure_of(function(), digits);
  }
  /// So many half widths of an element, in the unit of length.
  [[nodiscard]] Interval length(long half_elements) const {
    return contact.grid.elements(half_elements) * half_thickness_of(problem);
  }
  [[nodiscard]] Interval indentation() const { return contact.indentation * half_thickness_of(problem); }
  /// d0 - Y^2/(2R)
  [[nodiscard]] Interval displacement_at(long half_elements) const {
    return indentation() -
           square(length(half_elements)) / (2 * Interval(problem.nip.roller_radius, working_bits()));
  }
  [[nodiscard]] Interval peak_load() const {
    Interval largest = contact.loads.front();
    for (const Interval& load : contact.loads) largest = larger_of(largest, load);
    return force_unit(problem) * largest;
  }
  /// Of the loads `counted` by the half widths of an element to them, in force.
  template <class Counted>
  [[nodiscard]] Interval moment(const Counted& counted) const {
    Interval total(working_bits());
    for (int j = 0; j < problem.loads(); ++j) {
      const long place = elements_to(problem, j);
      if (counted(place))
        total = total + contact.loads[static_cast<std::size_t>(j)] * contact.grid.elements(place);
    }
    return total * half_thickness_of(problem) * force_unit(problem);
  }
  /// The sum of each load's displacement(problem, grid, place, j).
  template <class Displacement>
  [[nodiscard]] Interval sum(const RollingPlace& place, const Displacement& displacement) const {
    Interval total(working_bits());
    for (int j = 0; j < problem.loads(); ++j)
      total =
          total + contact.loads[static_cast<std::size_t>(j)] * displacement(problem, contact.grid, place, j);
    return force_unit(problem) * total;
  }
  [[nodiscard]] double leading_length() const {
    return mpq_class(2 * problem.leading * contact.grid.element * problem.half_thickness()).get_d();
  }
  [[nodiscard]] RollingPlace place(double y) const {
    const double ahead = leading_length() + mpq_class(problem.approach * problem.half_thickness()).get_d();
    if (!(std::isfinite(y) && y <= ahead))
      throw BadInput("y", y, "must be finite, and not ahead of where the leading end started");
    const mpq_class distance = mpq_class(y) / problem.half_thickness();
    for (int j = 0; length_is_given && j < problem.loads(); ++j)
      if (distance == elements_to(problem, j) * contact.grid.element)
        throw BadInput("y", y, "must not be the place of a line load");
    return {distance, 0};
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
  (void)material_compliances(nip.material);  // which refuses what is no material
  const ExactMaterial material = exact_material(nip.material);
  if (method.residue_terms > 0 &&
      std::ranges::any_of(material.normal().terms, [](const auto& term) { return term.rate == 0; }))
    throw BadInput("residue_terms", std::to_string(method.residue_terms),
                   "must be 0: the material is a fluid, and the thesis's sums divide by its rate, 0");
  constexpr mpfr_prec_t bits = 512;  // of rates that are roots, so that what they miss is below all else
  return {nip,      with_given_rates(material, bits), method.leading_elements,
          trailing, mpq_class(method.approach),       method.residue_terms,
          digits};
}

/// contact_at(digits beyond), with more and more digits until it is `enough`; nothing where that does not come about.
template <class ContactAt, class Enough>
std::optional<LoadsOnLength> solved_until(RollingLoads& problem, int digits, const ContactAt& contact_at,
                                          const Enough& enough) {
  for (int extra = first_extra_digits; extra <= most_extra_digits; extra += extra) {
    problem.digits = digits + extra;
    const WorkingDigits scope(problem.digits + rounding_digits);
    std::optional<LoadsOnLength> contact = contact_at(extra);
    if (contact && enough(*contact)) return contact;
  }
  return std::nullopt;
}

auto is_good_to(int digits) {
  return [digits](const LoadsOnLength& contact) {
    return contact.error <= pow(Float(10), -(digits + spare_digits));
  };
}

}  // namespace

ViscoelasticLineLoads ViscoelasticLineLoads::for_length(const data::ViscoelasticNip& nip,
                                                        const ViscoelasticLineLoadMethod& method,
                                                        double contact_length, int digits) {
  RollingLoads problem = checked(nip, method, digits);
  if (!(contact_length > 0 && contact_length <= nip.roller_radius))
    throw BadInput("contact_length", contact_length, "must be > 0 and at most the roller's radius");
  int systems = 0;
  const auto contact_at = [&](int) {
    ++systems;
    return solve_loads(problem, {problem.element(mpq_class(contact_length)), 0});
  };
  std::optional<LoadsOnLength> contact = solved_until(problem, digits, contact_at, is_good_to(digits));
  if (!contact)
    throw BadInput("contact_length", contact_length,
                   "must be one whose system is farther from singular than the reference can tell");
  return ViscoelasticLineLoads(std::make_shared<const Implementation>(
      Implementation{problem, *std::move(contact), digits, systems, true}));
}

ViscoelasticLineLoads ViscoelasticLineLoads::for_load(const data::ViscoelasticNip& nip,
                                                      const ViscoelasticLineLoadMethod& method, double load,
                                                      int digits) {
  constexpr int digits_of_search = 16 - first_extra_digits;  // the influences', that is, are 16 at first
  RollingLoads problem = checked(nip, method, digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  int systems = 0;
  LengthGuess guess{sqrt(Float(load) * Float(nip.roller_radius) * problem.instantaneous()) /
                    (2 * problem.leading * to_float(Exact(problem.half_thickness())))};
  const auto carrying = [&](int least_digits, const auto& enough) {
    const auto contact_at = [&](int extra) {
      return enclose_length(problem, guess, load, std::max(least_digits, 0) + extra / 2, systems);
    };
    std::optional<LoadsOnLength> contact = solved_until(problem, least_digits, contact_at, enough);
    if (contact) return *std::move(contact);
    throw BadInput("load", load, "must be one whose contact length can be proven");
  };
  const auto is_clear = [](const LoadsOnLength& contact) { return presses_everywhere(contact).has_value(); };
  while (!method.trailing_elements && problem.trailing > 0 &&
         presses_everywhere(carrying(digits_of_search, is_clear)) == false)
    --problem.trailing;
  LoadsOnLength contact = carrying(digits, is_good_to(digits));
  return ViscoelasticLineLoads(std::make_shared<const Implementation>(
      Implementation{problem, std::move(contact), digits, systems, false}));
}

Enclosure ViscoelasticLineLoads::contact_length() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.length(2L * all.problem.loads()); });
}

Enclosure ViscoelasticLineLoads::leading_length() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.length(2L * all.problem.leading); });
}

Enclosure ViscoelasticLineLoads::trailing_length() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.length(2L * all.problem.trailing); });
}

Enclosure ViscoelasticLineLoads::indentation() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.indentation(); });
}

Enclosure ViscoelasticLineLoads::leading_displacement() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.displacement_at(2L * all.problem.leading); });
}

Enclosure ViscoelasticLineLoads::trailing_displacement() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.displacement_at(2L * all.problem.trailing); });
}

Enclosure ViscoelasticLineLoads::load() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return load_of(all.problem, all.contact); });
}

Enclosure ViscoelasticLineLoads::peak_pressure() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.peak_load() / all.length(2); });
}

Enclosure ViscoelasticLineLoads::peak_pressure_position() const {
  const auto& all = *implementation_;
  return all.enclosed([&] {
    const Interval peak = all.peak_load(), unit = force_unit(all.problem);
    std::optional<Interval> place;
    for (int j = 0; j < all.problem.loads(); ++j) {
      const Interval force = unit * all.contact.loads[static_cast<std::size_t>(j)];
      if (mpfr_less_p(force.upper(), peak.lower()) != 0) continue;
      const Interval here = all.length(elements_to(all.problem, j));
      place = place ? hull(*place, here) : here;
    }
    return *place;
  });
}

Enclosure ViscoelasticLineLoads::rolling_resistance() const {
  const auto& all = *implementation_;
  return all.enclosed([&] {
    return all.moment([](long) { return true; }) /
           (load_of(all.problem, all.contact) * Interval(all.problem.nip.roller_radius, working_bits()));
  });
}

Enclosure ViscoelasticLineLoads::leading_moment() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.moment([](long place) { return place > 0; }); });
}

Enclosure ViscoelasticLineLoads::trailing_moment() const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.moment([](long place) { return place < 0; }); });
}

Enclosure ViscoelasticLineLoads::creep_ratio() const {
  const auto& all = *implementation_;
  return all.enclosed([&] {
    const auto at = [&](long elements) { return all.sum({0, elements}, tangential_at); };
    return (at(2L * all.problem.leading) - at(-2L * all.problem.trailing)) /
           all.length(2L * all.problem.loads());
  });
}

Enclosure ViscoelasticLineLoads::pressure(double y) const {
  const auto& all = *implementation_;
  const double leading = all.leading_length();
  const double width = leading / all.problem.leading, border = 0x1p-50 * leading;
  const double ahead = leading - y;
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  if (ahead < -border || ahead > all.problem.loads() * width + border) return exact_zero(all.digits);
  const auto element = static_cast<std::size_t>(std::max(0.0, ahead + border) / width);
  return all.enclosed([&] {
    return force_unit(all.problem) * all.contact.loads[std::min(element, all.contact.loads.size() - 1)] /
           all.length(2);
  });
}

std::vector<FaceLoad> ViscoelasticLineLoads::face_loads() const {
  const auto& all = *implementation_;
  std::vector<FaceLoad> loads;
  for (int j = 0; j < all.problem.loads(); ++j) {
    const auto place = [&] { return all.length(elements_to(all.problem, j)); };
    const auto force = [&] {
      return force_unit(all.problem) * all.contact.loads[static_cast<std::size_t>(j)];
    };
    loads.push_back({all.enclosed(place), all.enclosed(force), exact_zero(all.digits)});
  }
  return loads;
}

Enclosure ViscoelasticLineLoads::normal_displacement(double y) const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.sum(all.place(y), normal_at); });
}

Enclosure ViscoelasticLineLoads::tangential_displacement(double y) const {
  const auto& all = *implementation_;
  return all.enclosed([&] { return all.sum(all.place(y), tangential_at) - all.sum({0, 0}, tangential_at); });
}

int ViscoelasticLineLoads::systems() const { return implementation_->systems; }
int ViscoelasticLineLoads::elements() const { return implementation_->problem.loads(); }

}  // namespace nipref::ref
