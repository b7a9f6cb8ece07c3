#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numeric>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/elastic_nip/internal/line_loads_search.hpp>

namespace nipref::fast {
namespace {

constexpr int most_solves = 200;

/// Of (2.13): W grows like L^3 if the sheet's indented area is what carries the load.
constexpr double exponent_of_the_thesis = 3;

void check(double load, const LoadSearch& search) {
  if (!(std::isfinite(load) && load > 0)) throw data::BadInput("load", load, "must be finite and > 0");
  if (!(search.tolerance >= 1e-14 && search.tolerance <= 0.1)) {
    throw data::BadInput("tolerance", search.tolerance, "must satisfy 1e-14 <= tolerance <= 0.1");
  }
}

[[noreturn]] void give_up(double load) {
  throw data::BadInput("load", load, "no contact length was found that carries it");
}

/// The length that carries `load` if W grows like L^exponent.
double next_length(double length, double load, double carried, double exponent = exponent_of_the_thesis) {
  return length * std::pow(load / carried, 1 / exponent);
}

double bracket(const std::function<double(double)>& load_of_length, double load, double length,
               double tolerance) {
  const double carried = load_of_length(length);
  const double estimate = carried > 0 ? next_length(length, load, carried) : 2 * length;
  const auto narrow_enough = [&](double shorter, double longer) {
    return longer - shorter <= tolerance * longer;
  };
  std::uintmax_t solves = most_solves;
  const auto [shorter, longer] = boost::math::tools::bracket_and_solve_root(
      [&](double at) { return load_of_length(at) / load - 1; }, estimate, 1.5, true, narrow_enough, solves);
  if (solves >= most_solves) give_up(load);
  return std::midpoint(shorter, longer);
}

/// Exponent of W(L) between two solves; the thesis's where they do not give a positive one.
double exponent_between(double length, double carried, double last_length, double last_carried) {
  const double exponent = std::log(carried / last_carried) / std::log(length / last_length);
  return exponent > 0.1 && exponent < 20 ? exponent : exponent_of_the_thesis;
}

}  // namespace

double contact_length_for_load(const std::function<double(double)>& load_of_length, double load,
                               double trial_length, const LoadSearch& search) {
  check(load, search);
  if (search.iteration == LoadSearch::Iteration::fast) {
    return bracket(load_of_length, load, trial_length, search.tolerance);
  }
  const auto length = contact_length_near(load_of_length, load, trial_length, search);
  if (!length) give_up(load);
  return *length;
}

std::optional<double> contact_length_near(const std::function<std::optional<double>(double)>& load_of_length,
                                          double load, double trial_length, const LoadSearch& search) {
  check(load, search);
  double length = trial_length;
  double last_length = 0;
  double last_carried = 0;
  for (int solve = 0; solve < most_solves; ++solve) {
    const std::optional<double> carried = load_of_length(length);
    if (!carried || !(*carried > 0)) return std::nullopt;
    if (std::abs(*carried / load - 1) <= search.tolerance) return length;
    const double exponent = solve > 0 && search.iteration == LoadSearch::Iteration::fast
                                ? exponent_between(length, *carried, last_length, last_carried)
                                : exponent_of_the_thesis;
    last_length = length;
    last_carried = *carried;
    length = next_length(length, load, *carried, exponent);
    if (length == last_length) return length;
  }
  give_up(load);
}

}  // namespace nipref::fast
