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

FieldIntegrand across(SheetLoad load, const mpq_class& s) {
  if (load == SheetLoad::normal) {
    return {
        false, false, {{-1, 0, sinh_over_S, false}, {-1, 1, cosh_over_S, false}, {s, 1, sinh_over_S, true}}};
  }
  return {true, false, {{-1, 1, sinh_over_S, false}, {s, 1, cosh_over_S, true}}};
}

FieldIntegrand along(SheetLoad load, const mpq_class& s) {
  if (load == SheetLoad::normal) {
    return {false,
            false,
            {{1, 1, cosh_over_S, false}, {-1, 0, sinh_over_S, false}, {mpq_class(-s), 1, sinh_over_S, true}}};
  }
  return {true,
          false,
          {{1, 1, sinh_over_S, false}, {-2, 0, cosh_over_S, false}, {mpq_class(-s), 1, cosh_over_S, true}}};
}

FieldIntegrand shear(SheetLoad load, const mpq_class& s) {
  if (load == SheetLoad::normal) {
    return {true, true, {{1, 1, cosh_over_S, true}, {mpq_class(-s), 1, sinh_over_S, false}}};
  }
  return {false, true, {{-1, 1, sinh_over_S, true}, {1, 0, cosh_over_S, true}, {s, 1, cosh_over_S, false}}};
}

FieldIntegrand displacement_across(SheetLoad load, const mpq_class& s, const ThetaShares& shares) {
  const mpq_class &t1 = shares.theta1, &t2 = shares.theta2;
  if (load == SheetLoad::normal) {
    return {false,
            true,
            {{-1, -1, sinh_over_S, true},
             {mpq_class(-t1), 0, cosh_over_S, true},
             {mpq_class(t1 * s), 0, sinh_over_S, false}}};
  }
  return {true,
          true,
          {{mpq_class(-t2), -1, cosh_over_S, true},
           {mpq_class(-t1), 0, sinh_over_S, true},
           {mpq_class(t1 * s), 0, cosh_over_S, false}}};
}

/// The integrand of v without the part that depends on eta.
FieldIntegrand displacement_along(SheetLoad load, const mpq_class& s, const ThetaShares& shares) {
  const mpq_class &t1 = shares.theta1, &t2 = shares.theta2;
  if (load == SheetLoad::normal) {
    return {true,
            false,
            {{mpq_class(-t2), -1, sinh_over_S, false},
             {t1, 0, cosh_over_S, false},
             {mpq_class(-t1 * s), 0, sinh_over_S, true}}};
  }
  return {false,
          false,
          {{1, -1, cosh_over_S, false},
           {mpq_class(-t1), 0, sinh_over_S, false},
           {mpq_class(t1 * s), 0, cosh_over_S, true}}};
}

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

/// The derivative whose first order has the integrand f G(z) times cosh z or sinh z and the cosine, or sine, of alpha z.
/// The second has a factor z more and the other wave.
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
  return by_parity(across(load, depth.magnitude().value()), alpha, depth, digits, decay_nats(alpha));
}

Enclosure sheet_along(const Exact& alpha, const Exact& depth, SheetLoad load, int digits) {
  check_place(alpha, depth);
  const double first_nats = load == SheetLoad::normal ? decay_nats(alpha) : 0;
  return by_parity(along(load, depth.magnitude().value()), alpha, depth, digits, first_nats);
}

Enclosure sheet_shear(const Exact& alpha, const Exact& depth, SheetLoad load, int digits) {
  check_place(alpha, depth);
  if (on_a_face(depth)) return exact_zero(digits);
  return by_parity(shear(load, depth.magnitude().value()), alpha, depth, digits, decay_nats(alpha));
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
  return by_parity(displacement_across(load, depth.magnitude().value(), ThetaShares(poisson)), alpha, depth,
                   digits, first_nats);
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
  const FieldIntegrand integrand = displacement_along(load, depth.magnitude().value(), shares);
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
