#include <algorithm>
#include <cmath>
#include <iterator>

#include <nipref/verify/seeds/internal/limit_rows.hpp>
#include <nipref/verify/seeds/limits.hpp>

namespace nipref::verify {

Propagated LimitSample::distance() const { return fabs(found - limit) / fabs(limit); }

std::optional<Propagated> LimitRow::measured_order() const {
  const LimitSample &before = *std::prev(samples.end(), 2), &last = samples.back();
  if (!last.distance().is_positive()) return {};
  return log(before.distance() / last.distance()) /
         log(Propagated::exact(before.size) / Propagated::exact(last.size));
}

bool LimitRow::approached() const {
  constexpr double agreement = 0.1, faster_than_powers = 4, told_apart = 0.01;
  const Propagated last = samples.back().distance();
  const std::optional<Propagated> measured = measured_order();
  if (order == 0) return !measured || measured->value() > faster_than_powers;
  return measured && last.error() < told_apart * last.value() &&
         std::fabs(measured->value() - order) <= agreement;
}

std::vector<LimitRow> limits() {
  std::vector<LimitRow> rows = elastic_limits();
  std::ranges::move(rolling_limits(), std::back_inserter(rows));
  return rows;
}

}  // namespace nipref::verify
