#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <variant>

#include <nipref/ref/number/estimated.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;

/// Times mu_R.
struct Product {
  ResultId id;
  bool has_radius, has_load, has_speed;
};
constexpr std::array products{Product{ResultId::eccentricity, true, false, false},
                              Product{ResultId::resistance_force, false, true, false},
                              Product{ResultId::power_loss, false, true, true}};

const Product* product_of(ResultId id) {
  const auto found = std::ranges::find(products, id, &Product::id);
  return found == products.end() ? nullptr : &*found;
}

/// What a product has of the scene; an elastic sheet loses nothing, whatever its speed.
struct FactorOf {
  const Product& product;

  double operator()(const data::ElasticNipProblem& problem) const {
    return product.has_radius ? problem.nip.roller_radius : 1;
  }
  double operator()(const data::ViscoelasticNipProblem& problem) const {
    return (product.has_radius ? problem.nip.roller_radius : 1) * (product.has_speed ? problem.nip.speed : 1);
  }
  double operator()(const data::HalfSpaceProblem&) const { return 1; }
};

Estimate multiplied(const Estimate& a, const Estimate& b) { return a * b; }

mpq_class rational(const std::string& text) { return ref::Exact::parse(text).value(); }

/// As many digits as the longer of the texts it comes from.
LongEstimate long_estimate_of(const mpq_class& exact, const mpq_class& error, const LongEstimate& a,
                              const LongEstimate& b) {
  const int digits = static_cast<int>(std::max(a.value.size(), b.value.size()));
  ref::Real value(static_cast<mpfr_prec_t>(4 * digits + 64)), bound(64);
  mpfr_set_q(value.get(), exact.get_mpq_t(), MPFR_RNDN);
  // The value's own rounding is far below its last digit's.
  mpfr_set_q(bound.get(), mpq_class(error * mpq_class(1000001, 1000000)).get_mpq_t(), MPFR_RNDU);
  const ref::Estimated result(value, bound, digits);
  return {result.value_text(), result.error_text(), a.proven && b.proven};
}

/// Of the decimals as they stand.
LongEstimate multiplied(const LongEstimate& a, const LongEstimate& b) {
  const mpq_class va = rational(a.value), vb = rational(b.value), ea = rational(a.error),
                  eb = rational(b.error);
  return long_estimate_of(va * vb, abs(va) * eb + abs(vb) * ea + ea * eb, a, b);
}

LongEstimate less(const LongEstimate& a, const LongEstimate& b) {
  return long_estimate_of(rational(a.value) - rational(b.value), rational(a.error) + rational(b.error), a, b);
}

bool same(const LongEstimate& a, const LongEstimate& b) { return a.value == b.value && a.error == b.error; }

Estimate exact_number(double value, const Estimate&) { return {value, 0}; }
LongEstimate exact_number(double value, const LongEstimate&) {
  ref::Real real(64), none(64);
  mpfr_set_d(real.get(), value, MPFR_RNDN);
  return {ref::Estimated(real, none, 40).value_text(), "0", true};
}

/// int p Y dY from a to b, of which either may be an end of the contact, where p falls like a root.
template <unsigned points>
Estimate moment_by_gauss(const SolvedContact<Estimate>& contact, double a, double b) {
  using Rule = boost::math::quadrature::gauss<double, points>;
  const double middle = a + (b - a) / 2;
  Estimate sum{0, 0};
  const auto add = [&](double end, double node, double weight) {
    const double t = (1 + node) / 2, reach = middle - end, y = end + reach * t * t;
    const double factor = weight * t * std::fabs(reach) * y;
    const Estimate pressure = contact.at(ResultId::pressure, y);
    sum.value += factor * pressure.value;
    sum.error += std::fabs(factor) * (pressure.error + 0x1p-51 * std::fabs(pressure.value));
  };
  for (const double end : {a, b}) {
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      const double node = Rule::abscissa()[k], weight = Rule::weights()[k];
      add(end, node, weight);
      if (node != 0) add(end, -node, weight);
    }
  }
  return sum;
}

}  // namespace

bool is_product(ResultId id) { return product_of(id) != nullptr; }
bool is_moment(ResultId id) { return id == ResultId::leading_moment || id == ResultId::trailing_moment; }

Estimate moment_of_pressure(const SolvedContact<Estimate>& contact, ResultId id) {
  const Estimate leading = contact.number(ResultId::leading_length),
                 trailing = contact.number(ResultId::trailing_length);
  const bool is_leading = id == ResultId::leading_moment;
  // All of the contact may be ahead.
  const double a = is_leading ? std::max(0.0, -trailing.value) : -trailing.value;
  const double b = is_leading ? leading.value : 0;
  if (!(b > a)) return {0, 0};
  const Estimate fine = moment_by_gauss<60>(contact, a, b), coarse = moment_by_gauss<30>(contact, a, b);
  return {fine.value, fine.error + 2 * std::fabs(fine.value - coarse.value)};
}

template <class Number>
Number WithDerivedResults<Number>::number(ResultId id) const {
  const Product* const product = product_of(id);
  if (product == nullptr) return contact_.number(id);
  Number result = contact_.number(ResultId::rolling_resistance);
  if (product->has_load) result = multiplied(result, contact_.number(ResultId::load));
  return multiplied(result, exact_number(std::visit(FactorOf{*product}, scene_.system), result));
}

template <class Number>
const Number& WithDerivedResults<Number>::strain(double y) const {
  const auto known = strains_.find(y);
  return known != strains_.end()
             ? known->second
             : strains_.emplace(y, contact_.at(ResultId::surface_strain, y)).first->second;
}

template <>
Estimate WithDerivedResults<Estimate>::slip(double y) const {
  return contact_.at(ResultId::slip, y);
}

template <>
LongEstimate WithDerivedResults<LongEstimate>::slip(double y) const {
  if (!creep_) creep_ = contact_.number(ResultId::creep_ratio);
  const LongEstimate& stretched = strain(y);
  // What sticks has the creep ratio itself for its strain.
  const auto* const elastic = std::get_if<data::ElasticNipProblem>(&scene_.system);
  const bool grips = elastic != nullptr && elastic->friction == data::Friction::full;
  if (grips && same(stretched, *creep_)) return {"0", "0", stretched.proven};
  return less(stretched, *creep_);
}

template <class Number>
Number WithDerivedResults<Number>::at(ResultId id, double y) const {
  if (id == ResultId::slip) return slip(y);
  return id == ResultId::surface_strain ? strain(y) : contact_.at(id, y);
}

template <class Number>
std::optional<double> WithDerivedResults<Number>::least_size(ResultId id, double y) const {
  if (is_moment(id)) {
    if (!contact_.least_size(ResultId::rolling_resistance, y)) return {};
    const double half = (value_of(contact_.number(ResultId::leading_length)) +
                         value_of(contact_.number(ResultId::trailing_length))) /
                        2;
    return half * value_of(contact_.number(ResultId::load));
  }
  const Product* const product = product_of(id);
  if (product == nullptr) return contact_.least_size(id, y);
  auto size = contact_.least_size(ResultId::rolling_resistance, y);
  if (!size) return {};
  const double load = product->has_load ? value_of(contact_.number(ResultId::load)) : 1;
  return *size * load * std::fabs(std::visit(FactorOf{*product}, scene_.system));
}

template class WithDerivedResults<Estimate>;
template class WithDerivedResults<LongEstimate>;

}  // namespace nipref::verify
