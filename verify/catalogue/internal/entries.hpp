#pragma once
#include <nipref/verify/catalogue/named_point.hpp>
#include <nipref/verify/catalogue/quantity.hpp>
#include <nipref/verify/formulas/internal/formulas.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

// The quantities with their evaluators. A new quantity is a row of quantities.toml and an entry of one of
// these groups.

/// Roots of sinh 2z + 2z = 0, thesis appendix IV; I1 to I7, (4.9), (4.20); F1, F2, un, vn, us, vs, (4.24), (4.25).
std::vector<Quantity> kernel_entries();
std::vector<Quantity> memory_entries();       ///< J1 to J6, thesis (6.20)
std::vector<Quantity> moving_load_entries();  ///< Un, Vn, started and steady, thesis (6.23) to (6.28)
std::vector<Quantity> half_space_entries();   ///< K, S, isotropic, brock2012 (18a)
std::vector<Quantity> transverse_half_space_entries();  ///< K, S, critical speeds, brock2013 (19), (43), (46)
std::vector<Quantity> half_space_contact_entries();     ///< dies and spheres, brock2012 (26) to (53)
std::vector<Quantity> seed_sphere_entries();  ///< the seed's sphere, brock2013 (34), and its exact contact
std::vector<Quantity> anisotropic_entries();  ///< K, S, critical speeds, any anisotropy, brock2013 appendix A
std::vector<Quantity> elastic_nip_entries();  ///< contacts of an elastic nip, dimensionless, thesis chapter V
std::vector<Quantity> field_entries();        ///< fields in the sheet, thesis (3.19), (3.20), (3.26), (3.27)
std::vector<Quantity> viscoelastic_nip_entries();  ///< contacts of a rolling nip, thesis chapter VII
std::vector<Quantity>
material_entries();  ///< theta1, theta2, moduli in time and at a frequency, thesis 6.12-6.17

/// Draws a time at which a load that started a time t ago passes a point, by passing_time() of quantities.toml.
double draw_passing_time(double t, Random& random);

/// Values of an argument of that kind at which large errors are likely; for quantities that do not draw their points.
std::vector<double> hard_values(ArgumentKind kind);

/// The rows of quantities.toml in their order, without evaluators.
const std::vector<Quantity>& described_quantities();

/// The row of that name; the reference stays valid. std::logic_error if the table has no such row.
const Quantity& described(std::string_view name);

template <std::size_t n>
using ArgumentNames = const char* const (&)[n];

/// Makes an evaluator of a point from a function of numbers: each of its first parameters is the argument of that name,
/// looked up here, once.
template <std::size_t n, class Function>
auto of_point(const Quantity& entry, ArgumentNames<n> names, Function function) {
  std::array<std::size_t, n> at{};
  for (std::size_t i = 0; i < n; ++i) at[i] = argument_number(entry.arguments, names[i]);
  return [at, function](auto numbers, auto... more) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
      if constexpr (std::is_invocable_v<Function, decltype(numbers[i])..., decltype(more)...>) {
        return function(numbers[at[i]]..., more...);
      } else {
        return function(numbers[at[i]]...);
      }
    }
    (std::make_index_sequence<n>());
  };
}

/// The same for a function that takes the whole point and gets its numbers by name.
template <class Function>
auto of_point(const Quantity& entry, Function function) {
  return [arguments = std::span<const Argument>(described(entry.name).arguments), function](auto numbers,
                                                                                            auto... more) {
    const Named named(arguments, numbers);
    if constexpr (std::is_invocable_v<Function, decltype(named), decltype(more)...>) {
      return function(named, more...);
    } else {
      return function(named);
    }
  };
}

/// Functions of a point by the names that quantities.toml has for them.
using PointFunctions = std::map<std::string, double (*)(const NamedPoint& x)>;
const PointFunctions& point_functions();

/// The value of a formula with the functions of [sampling] in quantities.toml and the given numbers.
double drawn(const std::string& formula, Random& random, const GivenNumbers& given = {});

/// The largest number of arguments of a quantity; the catalogue's test checks every entry.
inline constexpr std::size_t most_arguments = 160;

/// Sets the scalar evaluator and the loop over it. As `evaluate` has its own type here, the loop calls it directly, and
/// the bench does not time a call of std::function.
template <class Evaluate>
void set_fast(Quantity& entry, Evaluate evaluate) {
  entry.by_fast = evaluate;
  entry.by_fast_loop = [evaluate](Quantity::Columns columns, std::span<double> values,
                                  fast::Accuracy accuracy) {
    std::array<double, most_arguments> point{};
    const std::span<const double> arguments(point.data(), columns.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      for (std::size_t j = 0; j < columns.size(); ++j) point[j] = columns[j][i];
      values[i] = evaluate(arguments, accuracy);
    }
  };
}

/// Makes an entry of functions of the numbers of these arguments, then digits or accuracy. `size` if the row has none.
template <std::size_t n, class Ref, class Fast, class... Size>
Quantity entry_of(const char* name, ArgumentNames<n> names, Ref by_ref, Fast by_fast, Size... size) {
  Quantity entry = described(name);
  entry.by_ref = of_point(entry, names, by_ref);
  set_fast(entry, of_point(entry, names, by_fast));
  ((entry.envelope = of_point(entry, names, size)), ...);
  return entry;
}

/// Makes an entry. `by_ref` takes a NamedExact and digits, `by_fast` a NamedPoint and an accuracy, `size` a NamedPoint.
template <class Ref, class Fast, class... Size>
Quantity entry_of(const char* name, Ref by_ref, Fast by_fast, Size... size) {
  Quantity entry = described(name);
  entry.by_ref = of_point(entry, by_ref);
  // Looking the numbers up by name takes longer than a call of std::function.
  set_fast(entry, decltype(entry.by_fast)(of_point(entry, by_fast)));
  ((entry.envelope = of_point(entry, size)), ...);
  return entry;
}

/// The entry with a function that draws the points of its audits: `draw` changes a point of the defaults at random.
template <class Draw>
Quantity sampled(Quantity entry, Draw draw) {
  entry.draw = [arguments = std::span<const Argument>(described(entry.name).arguments),
                defaults = point_of(entry, {}), draw](Random& random) {
    Point point = defaults;
    draw(random, NamedNumbers(arguments, point));
    return point;
  };
  return entry;
}
/// The same; `keep_off` moves a point into the domain.
template <class Draw, class KeepOff>
Quantity sampled(Quantity entry, Draw draw, KeepOff keep_off) {
  entry.keep_off = [arguments = std::span<const Argument>(described(entry.name).arguments),
                    keep_off](Point& point) { keep_off(NamedNumbers(arguments, point)); };
  return sampled(std::move(entry), draw);
}

/// Sets the numbers of those keys to their defaults.
void set_defaults(const NamedNumbers& x, const std::vector<ModelKey>& keys);

}  // namespace nipref::verify
