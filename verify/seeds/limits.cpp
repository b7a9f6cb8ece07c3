#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {

double LimitSample::distance() const { return std::fabs(found.value - limit) / std::fabs(limit); }
double LimitSample::error() const { return found.error / std::fabs(limit); }

double LimitRow::measured_order() const {
  const LimitSample &before = *std::prev(samples.end(), 2), &last = samples.back();
  if (last.distance() <= last.error()) return std::numeric_limits<double>::infinity();
  return std::log(before.distance() / last.distance()) / std::log(before.size / last.size);
}

bool LimitRow::approached() const {
  constexpr double agreement = 0.1, faster_than_powers = 4, told_apart = 0.01;
  const LimitSample& last = samples.back();
  if (order == 0) return measured_order() > faster_than_powers;
  return last.error() < told_apart * last.distance() && std::fabs(measured_order() - order) <= agreement;
}

std::vector<LimitRow> limits() {
  std::vector<LimitRow> rows = elastic_limits();
  std::ranges::move(rolling_limits(), std::back_inserter(rows));
  return rows;
}

}  // namespace nipref::verify
