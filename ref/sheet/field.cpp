#include <algorithm>
#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/ref/sheet/internal/field_integral.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

using data::Derivative;
using data::SheetLoad;
using enum FieldSymbol;

void check_place(const Exact& alpha, const Exact& depth) {
  check_argument(alpha, "alpha");
  if (abs(depth.value()) > 1) {
    throw data::BadInput("depth", depth.approximate(), "must satisfy -1 <= depth <= 1");
  }
  if (alpha.sign() == 0 && abs(depth.value()) == 1) {
    throw data::BadInput("alpha", "0", "must be nonzero on the faces: the load is there");
  }
}

bool on_a_face(const Exact& depth) { return abs(depth.value()) == 1; }

/// The form of all stresses and displacements: first z^(power - 1) G C + second z^power (H C - s G D), times a wave.
/// Under a normal load G = 2 sinh z/S and H = 2 cosh z/S; under a shear load they are exchanged. C is sinh sz if the
/// quantity is odd in the depth s, otherwise cosh sz; D is the other of the two. A normal load's wave is sin alpha z if
/// `odd_if_normal`, otherwise cos alpha z; a shear load has -cos alpha z and sin alpha z instead.
struct FieldForm {
  bool odd_if_normal = false, odd_in_depth = false;
  int power = 0;
  mpq_class first_if_normal = 0, first_if_shear = 0, second = 0;

  [[nodiscard]] FieldIntegrand at(SheetLoad load, const Exact& depth) const {
    const bool is_normal = load == SheetLoad::normal;
    const FieldSymbol G = is_normal ? sinh_over_S : cosh_over_S, H = is_normal ? cosh_over_S : sinh_over_S;
    const bool has_sine = is_normal ? odd_if_normal : !odd_if_normal;
    const int sign = !is_normal && !has_sine ? -1 : 1;
    const mpq_class first = sign * (is_normal ? first_if_normal : first_if_shear), of_H = sign * second,
                    of_G = -of_H * depth.magnitude().value();
    FieldIntegrand result{
        has_sine, odd_in_depth, {{of_H, power, H, odd_in_depth}, {of_G, power, G, !odd_in_depth}}};
    if (first != 0) result.terms.push_back({first, power - 1, G, odd_in_depth});
    return result;
  }
};

/// About -ln of the size of the field far from the load.
double decay_nats(const Exact& alpha) { return slowest_decay * std::abs(alpha.approximate()); }

/// The quantity at (|alpha|, |depth|) with the sign that its parities give.
Enclosure by_parity(const FieldIntegrand& integrand, const Exact& alpha, const Exact& depth, int digits,
                    double first_nats) {
  const bool odd_in_alpha = integrand.sine;
  const int sign = (odd_in_alpha ? alpha.sign() : 1) * (integrand.odd_in_depth ? depth.sign() : 1);
  if (sign == 0) return exact_zero(digits);
  const FieldPoint at{alpha.magnitude(), depth.magnitude()};
  return enclose(digits, first_nats, [&](double nats) {
    const Interval value = field_integral(integrand, at, nats);
    return sign < 0 ? -value : value;
  });
}

/// A derivative of a face's displacement. The first derivative has the integrand `first` times sin alpha z or cos alpha
/// z. The second has one more factor z and the other wave.
Enclosure on_face(const FieldTerm& first, bool sine, const Exact& alpha, Derivative order, int digits,
                  double first_nats) {
  const Exact face(1.0);
  check_place(alpha, face);
  FieldIntegrand integrand{sine, first.sinh, {first}};
  if (order == Derivative::second) {
    FieldTerm& term = integrand.terms.front();
    integrand.sine = !sine;
    term.power = 1;
    if (!sine) term.factor = -term.factor;
  }
  return by_parity(integrand, alpha, face, digits, first_nats);
}

}  // namespace

Enclosure sheet_across(const Exact& alpha, const Exact& depth, SheetLoad load, int digits) {
  check_place(alpha, depth);
  if (on_a_face(depth)) return exact_zero(digits);
  const FieldForm form{.power = 1, .first_if_normal = -1, .second = -1};
  return by_parity(form.at(load, depth), alpha, depth, digits, decay_nats(alpha));
}

Enclosure sheet_along(const Exact& alpha, const Exact& depth, SheetLoad load, int digits) {
  check_place(alpha, depth);
  const double first_nats = load == SheetLoad::normal ? decay_nats(alpha) : 0;
  const FieldForm form{.power = 1, .first_if_normal = -1, .first_if_shear = -2, .second = 1};
  return by_parity(form.at(load, depth), alpha, depth, digits, first_nats);
}

Enclosure sheet_shear(const Exact& alpha, const Exact& depth, SheetLoad load, int digits) {
  check_place(alpha, depth);
  if (on_a_face(depth)) return exact_zero(digits);
  const FieldForm form{
      .odd_if_normal = true, .odd_in_depth = true, .power = 1, .first_if_shear = -1, .second = 1};
  return by_parity(form.at(load, depth), alpha, depth, digits, decay_nats(alpha));
}

Enclosure un_slope(const Exact& alpha, Derivative order, int digits) {
  return on_face({-1, 0, sinh_over_S, true}, true, alpha, order, digits, decay_nats(alpha));
}

Enclosure vn_slope(const Exact& alpha, Derivative order, int digits) {
  return on_face({-1, 0, sinh_over_S, false}, false, alpha, order, digits, decay_nats(alpha));
}

Enclosure vs_slope(const Exact& alpha, Derivative order, int digits) {
  const double first_nats = order == Derivative::first ? 0 : decay_nats(alpha);
  return on_face({-1, 0, cosh_over_S, false}, true, alpha, order, digits, first_nats);
}

Enclosure sheet_u(const Exact& alpha, const Exact& depth, SheetLoad load, const Exact& poisson, int digits) {
  check_place(alpha, depth);
  check_poisson(poisson);
  const double first_nats = load == SheetLoad::normal ? decay_nats(alpha) : 0;
  const auto& [t1, t2] = ThetaShares(poisson);
  const FieldForm form{.odd_in_depth = true, .first_if_normal = -1, .first_if_shear = -t2, .second = -t1};
  return by_parity(form.at(load, depth), alpha, depth, digits, first_nats);
}

Enclosure sheet_v(const Exact& alpha, const Exact& eta, const Exact& depth, SheetLoad load,
                  const Exact& poisson, int digits) {
  check_place(alpha, depth);
  check_argument(eta, "eta");
  check_poisson(poisson);
  const bool odd = load == SheetLoad::normal;
  if (odd && alpha.sign() == 0 && eta.sign() == 0) return exact_zero(digits);
  if (depth.sign() == 0 &&
      (alpha.value() == eta.value() || (!odd && abs(alpha.value()) == abs(eta.value())))) {
    return exact_zero(digits);
  }
  const ThetaShares shares(poisson);
  // The displacement without the part that depends on eta.
  const auto& [t1, t2] = shares;
  const FieldForm form{.odd_if_normal = true, .first_if_normal = -t2, .first_if_shear = -1, .second = t1};
  const FieldIntegrand integrand = form.at(load, depth);
  const FieldPoint at{alpha.magnitude(), depth.magnitude()};
  // Far from the load, on the side of the fixed point, the parts that do not decay cancel.
  const bool same_side = !odd || alpha.sign() * eta.sign() > 0;
  const double nearer = std::min(std::abs(alpha.approximate()), std::abs(eta.approximate()));
  return enclose(digits, same_side ? slowest_decay * nearer : 0, [&](double nats) {
    const Interval of_eta = fixed_point_interval(load, eta, shares, nats);
    if (odd && alpha.sign() == 0) return of_eta;
    const Interval value = field_integral(integrand, at, nats);
    return odd && alpha.sign() < 0 ? of_eta - value : of_eta + value;
  });
}

}  // namespace nipref::ref
