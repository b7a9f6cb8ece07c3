#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <variant>

#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/number/estimate.hpp>
#include <nipref/ref/number/exact.hpp>
#include <nipref/verify/solve/internal/derived_results.hpp>

namespace nipref::verify {
namespace {

using fast::Estimate;

/// The product of mu_R with the factors named here.
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

/// The factors that the scene gives. The speed of an elastic sheet does not matter, as the sheet loses no energy.
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

Estimate exactly(double value, const Estimate&) { return {value, 0}; }
ref::Estimate exactly(double value, const ref::Estimate& like) { return ref::exactly(value, like.digits); }

bool same(const ref::Estimate& a, const ref::Estimate& b) {
  return mpfr_equal_p(a.value.get(), b.value.get()) != 0 && mpfr_equal_p(a.error.get(), b.error.get()) != 0;
}

/// int p Y dY from a to b, each of which may be an end of the contact, next to which p is like a square root.
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
  // The whole contact may be ahead of the line through the centres.
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
  if (product->has_load) result = result * contact_.number(ResultId::load);
  return result * exactly(std::visit(FactorOf{*product}, scene_.system), result);
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
ref::Estimate WithDerivedResults<ref::Estimate>::slip(double y) const {
  if (!creep_) creep_ = contact_.number(ResultId::creep_ratio);
  const ref::Estimate& stretched = strain(y);
  // Where the surface sticks, its strain is the creep ratio.
  const auto* const elastic = std::get_if<data::ElasticNipProblem>(&scene_.system);
  const bool grips = elastic != nullptr && elastic->friction == data::Friction::full;
  if (!grips || !same(stretched, *creep_)) return stretched - *creep_;
  ref::Estimate none = exactly(0, stretched);
  none.proven = stretched.proven;
  return none;
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
template class WithDerivedResults<ref::Estimate>;

}  // namespace nipref::verify
