#pragma once
#include <compare>
#include <concepts>

#include <nipref/data/scene/results.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/verify/solve/solve.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

using data::ResultId;

/// A place of a profile or field: Y along the sheet, and the depth over half the thickness. On a half-space y is an
/// angle from the motion in degrees, or a position on the scene's line.
struct Place {
  double y, depth = 0;
  auto operator<=>(const Place&) const = default;
};
using Places = std::vector<Place>;

/// A number without an error, as another number is.
inline fast::Estimate exactly(double value, const fast::Estimate&) { return {value, 0}; }
inline ref::Estimate exactly(double value, const ref::Estimate& like) {
  return ref::exactly(value, like.digits);
}

/// The ends of a contact, or of a half-space's angles: Y, unit of length.
struct ContactEnds {
  double first, last;
};

/// What the error of a result is measured against, see data::Scale.
enum class Measure {
  size,  ///< the larger of the result and its size
  itself,  ///< the result alone, except for stresses inside the sheet, and the place of the largest pressure, which
           ///< may be 0
  truth  ///< nothing: the error is the distance to the continuous contact, which no accuracy makes smaller
};

/// A solved contact of either path: a function for each of its results. A result is computed when it is first asked
/// for, and cached.
template <class Number>
struct SolvedContact {
  SolvedContact() = default;
  SolvedContact(const SolvedContact&) = delete;
  SolvedContact& operator=(const SolvedContact&) = delete;

  /// The numbers of a result: one, all of a list, or one for each place of a profile or field.
  [[nodiscard]] const std::vector<Number>& get(ResultId id, const Places& places = {}) const {
    const auto known = cache_.find({id, places});
    if (known != cache_.end()) return known->second;
    std::vector<Number> numbers = functions_.at(id)(places);
    return cache_.emplace(std::pair(id, places), std::move(numbers)).first->second;
  }
  [[nodiscard]] bool has(ResultId id) const { return functions_.contains(id); }
  [[nodiscard]] const Number& number(ResultId id) const { return get(id).front(); }
  [[nodiscard]] const Number& at(ResultId id, double y) const { return get(id, {{y}}).front(); }

  void set(ResultId id, std::function<std::vector<Number>(const Places&)> function) {
    functions_[id] = std::move(function);
  }
  void set(ResultId id, std::function<Number()> number) {
    set(id, [number = std::move(number)](const Places&) { return std::vector<Number>{number()}; });
  }
  void set(ResultId id, std::function<Number(double y)> at) {
    set(id, [at = std::move(at)](const Places& places) {
      return mapped(places, [&](const Place& place) { return at(place.y); });
    });
  }
  /// Sets a result of a solution to one of its members, or to another function of it: a number, a list, or a number at
  /// Y.
  template <class Solution>
  void set(ResultId id, const std::shared_ptr<Solution>& solution, auto function) {
    if constexpr (std::invocable<decltype(function), Solution&, double>) {
      set(id, [=](double y) { return number_of(std::invoke(function, *solution, y)); });
    } else if constexpr (std::ranges::range<std::invoke_result_t<decltype(function), Solution&>>) {
      set(id, [=](const Places&) {
        return mapped(std::invoke(function, *solution), [](const auto& one) { return number_of(one); });
      });
    } else {
      set(id, [=] { return number_of(std::invoke(function, *solution)); });
    }
  }

  /// Sets results that are parts of what is computed at once, at each place.
  template <class Whole>
  void set_parts(std::function<std::vector<Whole>(const Places&)> function,
                 const std::vector<std::pair<ResultId, std::function<Number(const Whole&)>>>& parts) {
    for (const ResultId id : std::views::keys(parts)) {
      set(id, [this, function, parts, id](const Places& places) {
        const std::vector<Whole> all = function(places);
        for (const auto& [other, part] : parts)
          cache_.emplace(std::pair(other, places), mapped<Number>(all, part));
        return cache_.at({id, places});
      });
    }
  }

  /// Solves again with more terms for smaller errors; false if this is not possible.
  bool refine() const {
    cache_.clear();
    return solve_again();
  }

  /// Where evenly spaced profiles begin and end: over half of a symmetric nip.
  [[nodiscard]] ContactEnds profile_ends() const {
    const ContactEnds all = ends();
    return {is_symmetric ? 0 : all.first, all.last};
  }

  std::function<ContactEnds()> ends = [] { return ContactEnds{0, 0}; };
  bool is_symmetric = false;
  double roller_radius = 0, speed = 1;  ///< of a nip; the speed of an elastic sheet does not matter
  Measure measure = Measure::size;
  std::function<bool()> solve_again = [] { return false; };
  /// The work so far on the results, and the work on their error estimates alone.
  std::function<fast::Work()> work = [] { return fast::Work{}; }, error_work = work;

 private:
  /// A double has no error yet.
  static Number number_of(const auto& found) {
    if constexpr (std::is_same_v<decltype(found), const double&>) {
      return {found, 0};
    } else {
      return found;
    }
  }

  std::map<ResultId, std::function<std::vector<Number>(const Places&)>> functions_;
  mutable std::map<std::pair<ResultId, Places>, std::vector<Number>> cache_;
};

/// The size that data::Scale describes for the error of a result, of a profile or a field at `y`, where the scene asks
/// for this accuracy.
template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy);

/// Whether it is leading_moment or trailing_moment.
bool is_moment(ResultId id);

/// Sets the results of a nip that are products of others; the errors follow from those of the factors:
///   eccentricity = R mu_R, resistance_force = W mu_R, power_loss = speed W mu_R     (thesis 7.12, 7.14, 7.15)
template <class Number>
void set_products(SolvedContact<Number>& contact);

/// Sets leading_moment = int p Y dY ahead of the line through the rollers' centres, and trailing_moment behind it
/// (thesis 7.13), by Gauss's rule. The error is the integrated error of the pressure and twice the difference from half
/// as many nodes.
void set_moments(SolvedContact<fast::Estimate>& contact);

/// Sets slip = v' - creep ratio, v' the strain of the surface: by (2.5) the surface moves at F_0 (1 + v') and the
/// rollers at F_0 (1 + creep ratio), so that the slip is the velocity of sliding over F_0. It is 0 in a contact with
/// full friction. Without friction the creep ratio is the mean strain, so that the mean slip in the contact is 0.
/// Outside the contact it is the slip that there would be if the surfaces touched.
void set_slip(SolvedContact<ref::Estimate>& contact, bool has_full_friction);

}  // namespace nipref::verify
