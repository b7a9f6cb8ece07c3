#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/grade/grade.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {
namespace {

/// The worst few decades, in ascending order. A domain may have six hundred decades.
std::vector<Decade> worst_decades(std::vector<Decade> decades) {
  constexpr std::size_t few = 12;
  if (decades.size() <= few) return decades;
  std::ranges::stable_sort(decades, std::greater<>(), &Decade::max_ulp);
  decades.resize(few);
  std::ranges::sort(decades, {}, &Decade::exponent);
  return decades;
}

Json decade_json(const Decade& decade) {
  return {{"exponent", decade.exponent ? Json(*decade.exponent) : Json()},
          {"points", decade.points},
          {"above_promise", decade.above},
          {"max_error_ulp", decade.max_ulp},
          {"median_error_ulp", decade.median_ulp},
          {"_from", decade.exponent ? fmt::format("1e{:+03}", *decade.exponent) : "0"}};
}

Json wrong_json(const Quantity& quantity, const WrongRegion& wrong) {
  return {{"first", point_json(quantity, wrong.lower)},
          {"last", point_json(quantity, wrong.upper)},
          {"points", wrong.points},
          {"above_promise", wrong.above}};
}

constexpr int condition_digits = 40;
constexpr double step = 0x1p-20;

/// f(..., x (1 + step), ...) - f(..., x (1 - step), ...)
double difference(const Quantity& quantity, const Point& point, std::size_t argument) {
  Point above = point, below = point;
  above[argument] *= 1 + step;
  below[argument] *= 1 - step;
  ref::Float change = ref_value(quantity, above, condition_digits).value;
  const ref::Float value_below = ref_value(quantity, below, condition_digits).value;
  mpfr_sub(ref::raw(change), ref::raw(change), ref::raw(value_below), MPFR_RNDN);
  return mpfr_get_d(ref::raw(change), MPFR_RNDN);
}

}  // namespace

std::optional<double> condition_number(const Quantity& quantity, const Point& point) try {
  const double value = ref_value(quantity, point, condition_digits).to_double();
  if (value == 0) return std::nullopt;
  double sum = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const ArgumentKind kind = quantity.arguments[i].kind;
    if (kind == ArgumentKind::choice || kind == ArgumentKind::index || point[i] == 0) continue;
    sum += std::fabs(difference(quantity, point, i) / (2 * step) / value);
  }
  return sum;
} catch (const data::BadInput&) {
  return std::nullopt;
}

Grade grade_of(std::string what, std::string where, AuditResult found) {
  const Quantity& quantity = *found.quantity;
  std::string worst_value = ref_value(quantity, found.worst, digits_beyond_double).value_text();
  const auto condition = condition_number(quantity, found.worst);
  return {std::move(what), std::move(where), std::move(found), condition, std::move(worst_value)};
}

Json grade_json(const Grade& grade) {
  const AuditResult& found = grade.found;
  const std::vector<Decade> worst = worst_decades(found.spread.decades);
  const std::size_t decades = found.spread.decades.size();
  Json row{{"graded", grade.what}, {"where", grade.where}};
  row.append(audit_row_json(found));
  row.append({{"worst_value", grade.worst_value},
              {"worst_condition", grade.condition},
              {"wrong", found.spread.wrong ? wrong_json(*found.quantity, *found.spread.wrong) : Json()},
              {"along", found.quantity->arguments[found.spread.along].name},
              {"decades", json_list(found.spread.decades, decade_json)},
              {"_scale", found.quantity->scale},
              // Without a promise in ulps: the error as a part of the scale. An ulp is at most 2^-52 of it.
              {"_part", found.promise == 0 ? Json(found.max_error_ulp * 0x1p-52) : Json()},
              {"_worst_decades", json_list(worst, decade_json)},
              {"_left_out_decades",
               worst.size() < decades ? Json{{"worst", worst.size()}, {"of", decades}} : Json()}});
  return row;
}

}  // namespace nipref::verify
