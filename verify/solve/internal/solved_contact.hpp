#pragma once
#include <compare>
#include <concepts>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <nipref/data/scene/results.hpp>
#include <nipref/fast/nip/work.hpp>
#include <nipref/verify/support/mapped.hpp>

namespace nipref::verify {

using data::ResultId;

/// A place of a profile or field: Y along the sheet, and the depth over half the thickness. On a half-space y is an
/// angle from the motion in degrees, or a position on the scene's line.
struct Place {
  double y, depth = 0;
  auto operator<=>(const Place&) const = default;
};
using Places = std::vector<Place>;

/// The ends of a contact, or of a half-space's angles: Y, unit of length.
struct ContactEnds {
  double first, last;
};

/// What the error of a result is measured against, see data::Scale.
enum class Measure {
  size,    ///< the larger of the result and its size
  itself,  ///< the result alone, except for stresses inside the sheet
  truth    ///< nothing: the error is the distance to the continuous contact, which no accuracy makes smaller
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
      set(id, [=](double y) -> Number { return std::invoke(function, *solution, y); });
    } else if constexpr (requires {
                           { std::invoke(function, *solution) } -> std::convertible_to<Number>;
                         }) {
      set(id, [=]() -> Number { return std::invoke(function, *solution); });
    } else {
      set(id, [=](const Places&) {
        const auto list = std::invoke(function, *solution);
        return std::vector<Number>(list.begin(), list.end());
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
  std::map<ResultId, std::function<std::vector<Number>(const Places&)>> functions_;
  mutable std::map<std::pair<ResultId, Places>, std::vector<Number>> cache_;
};

/// The size that data::Scale describes for the error of a result, of a profile or a field at `y`, where the scene asks
/// for this accuracy.
template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy);

}  // namespace nipref::verify
