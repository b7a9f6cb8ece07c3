#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

constexpr auto on_circle = "integral over a circle around the root";

Pole pole_of(Arguments x) { return pole_by_circle(static_cast<std::size_t>(x["n"])); }

Confirmation root_part(const Float& part) { return confirmation(on_circle, part, part * Float("1e-75")); }

/// The kernels are in the order of quantities.toml. I3, I4 and I5 are sine transforms.
Confirmation residue(Arguments x) {
  const Pole at = pole_of(x);
  const Complex by_kernel[]{I1.residue(at),       I3.residue(at),      I4.residue(at), I5.residue(at),
                            I6_alpha.residue(at), -I6_eta.residue(at), I7.residue(at)};
  const auto number = static_cast<std::size_t>(x["kernel"]);
  const Complex c = 2 * by_kernel[number];
  const bool odd = number >= 1 && number <= 3, first = x["coefficient"] == 0;
  const Float value = odd && !first ? c.real() : first && !odd ? Float(-c.real()) : Float(-c.imag());
  return confirmation(on_circle, value, abs(c) * Float("1e-75"));
}

Confirmation kernel(const Split& sum) {
  return confirmation("integral along the real axis or around the poles", sum.value(), sum.error);
}

/// The sum divided by pi and `divisor`.
Confirmation displacement(Split sum, const mpq_class& divisor = 1) {
  const Float by = pi() * to_number(divisor);
  sum.error = sum.error / by + abs(sum.value() / by) * Float("1e-95");
  return confirmation("integrals along the real axis or around the poles", sum.value() / by, sum.error);
}

/// The exact compliances of the sheet.
struct Compliances {
  mpq_class theta1, theta2, normal;

  explicit Compliances(Arguments x) : Compliances(x["young"], x["poisson"]) {}
  Compliances(double young, double poisson) {
    const mpq_class nu(poisson), E(young);
    theta1 = (1 + nu) / E;
    theta2 = (1 + nu) * (1 - 2 * nu) / E;
    normal = theta1 + theta2;
  }
};

Split F1_sum(const Compliances& c, const mpq_class& eta) {
  return Split{}.add(c.theta2, I4(eta)).add(-c.theta1, I5(eta));
}

Split us_sum(const Compliances& c, const mpq_class& alpha) {
  return Split{}.add(c.theta2, Split{2 * sgn(alpha), 0, 0}).add(-c.normal, I3(alpha));
}

Split I6_sum(const mpq_class& alpha, const mpq_class& eta) { return I6_alpha(alpha).add(-1, I6_eta(eta)); }

Confirmation vn(const Compliances& c, const mpq_class& alpha, const mpq_class& eta) {
  return displacement(F1_sum(c, eta).add(-1, us_sum(c, alpha)));
}

Confirmation vs(const Compliances& c, const mpq_class& alpha, const mpq_class& eta) {
  return displacement(Split{}.add(c.normal, I6_sum(alpha, eta)).add(c.theta1, I7(eta)));
}

Confirmation F2(const Compliances& c, const mpq_class& eta) {
  return displacement(Split{}.add(-1, I6_eta(eta)).add(mpq_class(c.theta1 / c.normal), I7(eta)));
}

/// The order of the kernels' derivatives: 1 for a face's slope, 2 for its curvature.
int order_of(Arguments x) { return x["order"] == 0 ? 1 : 2; }

/// A point inside the sheet: alpha >= 0 and 0 <= depth <= 1.
struct InnerPoint {
  Float alpha, depth;
};

enum class Component { sx, sy, txy, u, v };

/// The thesis's integrand without its factor cos or sin of alpha z, with `sine` in place of 2 sinh z/S and `cosine` in
/// place of 2 cosh z/S. K is a complex type for the residues at poles.
template <class K>
K integrand(Component part, bool normal, const Float& s, const Float& t1, const K& z, const K& sine,
            const K& cosine) {
  const K ch = cosh(s * z), sh = sinh(s * z);
  const Float t2 = 1 - t1;
  switch (part) {
    case Component::sx:
      return normal ? K(-(sine + z * cosine) * ch + s * z * sine * sh)
                    : K(-z * sine * ch + s * z * cosine * sh);
    case Component::sy:
      return normal ? K((z * cosine - sine) * ch - s * z * sine * sh)
                    : K((z * sine - 2 * cosine) * ch - s * z * cosine * sh);
    case Component::txy:
      return normal ? K(z * cosine * sh - s * z * sine * ch)
                    : K((cosine - z * sine) * sh + s * z * cosine * ch);
    case Component::u:
      return normal ? K(-sine * sh / z - t1 * (cosine * sh - s * sine * ch))
                    : K(-t2 * cosine * sh / z + t1 * (s * cosine * ch - sine * sh));
    case Component::v:
      break;
  }
  return normal ? K(-t2 * sine * ch / z + t1 * (cosine * ch - s * sine * sh))
                : K(cosine * ch / z - t1 * (sine * ch - s * cosine * sh));
}

bool is_sine(Component part, bool normal) {
  const bool odd_for_normal = part == Component::txy || part == Component::v;
  return odd_for_normal == normal;
}

/// pi times the fields of two half-planes under the loads: the integral with e^-z in place of sinh z/S and cosh z/S, in
/// closed form.
Float half_planes(Component part, bool normal, const InnerPoint& at, const Float& t1) {
  const Float &a = at.alpha, &s = at.depth;
  const Float d = 1 - s, D = 1 + s, r2 = d * d + a * a, R2 = D * D + a * a, t2 = 1 - t1;
  const Float r4 = r2 * r2, R4 = R2 * R2;
  switch (part) {
    case Component::sx:
      return normal ? Float(-2 * (d * d * d / r4 + D * D * D / R4))
                    : Float(-2 * a * (d * d / r4 + D * D / R4));
    case Component::sy:
      return normal ? Float(-2 * a * a * (d / r4 + D / R4)) : Float(-2 * a * a * a * (1 / r4 + 1 / R4));
    case Component::txy:
      return normal ? Float(2 * a * (d * d / r4 - D * D / R4)) : Float(2 * a * a * (d / r4 - D / R4));
    case Component::u:
      return normal ? Float(-log(R2 / r2) / 2 - t1 * (d * d / r2 - D * D / R2))
                    : Float(-t2 * (atan2(a, d) - atan2(a, D)) + t1 * a * (D / R2 - d / r2));
    case Component::v:
      break;
  }
  return normal ? Float(-t2 * (atan2(a, d) + atan2(a, D)) + t1 * a * (d / r2 + D / R2))
                : Float(-log(r2 * R2) / 2 - t1 * (d * d / r2 + D * D / R2));
}

/// pi times the quantity for alpha < far. For v it is the part that does not depend on eta.
Split near_sum(Component part, bool normal, const InnerPoint& at, const Float& t1) {
  const bool sine = is_sine(part, normal), twofold = part == Component::v && !normal;
  Split sum = integral([&](const Node& node) -> Float {
    const Float angle = at.alpha * node.z;
    const Float value =
        integrand<Float>(part, normal, at.depth, t1, node.z, node.sine_rest, node.cosine_rest) *
        (sine ? sin(angle) : cos(angle));
    return twofold ? Float(value - node.cosine_rest / node.z) : value;
  });
  sum.rest += half_planes(part, normal, at, t1);
  if (twofold) sum.add(1, I6_eta(0));
  sum.error += abs(sum.rest) * Float("1e-90");
  return sum;
}

Split far_sum(Component part, bool normal, const InnerPoint& at, const mpq_class& alpha, const Float& t1) {
  Split value = around_poles(at.alpha, is_sine(part, normal), 2000, [&](const Pole& pole) {
    return integrand<Complex>(part, normal, at.depth, t1, pole.z, pole.sine, pole.cosine);
  });
  if (normal && part == Component::v) value.rest += pi() / 4 * (2 * t1 - 1);
  if (!normal && part == Component::sy) value.rest -= pi() / 2;
  if (!normal && part == Component::u) value.rest += pi() / 4 * (2 * t1 - 1) * at.depth;
  if (!normal && part == Component::v) value.quarters = -alpha;
  return value;
}

Split sum_of(Component part, bool normal, const mpq_class& alpha, const mpq_class& depth,
             const mpq_class& poisson) {
  const InnerPoint at{to_number(abs(alpha)), to_number(abs(depth))};
  const Float t1 = 1 / to_number(2 * (1 - poisson));
  Split value = abs(alpha) < far ? near_sum(part, normal, at, t1) : far_sum(part, normal, at, abs(alpha), t1);
  const bool odd_in_depth = part == Component::txy || part == Component::u;
  const int sign = (is_sine(part, normal) ? sgn(alpha) : 1) * (odd_in_depth ? sgn(depth) : 1);
  return Split{}.add(sign, value);
}

Confirmation over_pi(const Split& sum) {
  const Float value = sum.value() / pi();
  return confirmation("half-planes and an integral along the real axis or around the poles", value,
                      sum.error / pi() + abs(value) * Float("1e-90"));
}

bool is_normal(Arguments x) { return x["load"] == 0; }

Confirmation stress(Component part, Arguments x) {
  const bool on_face = x["depth"] == 1 || x["depth"] == -1;
  if (on_face && part != Component::sy) return over_pi({});
  return over_pi(sum_of(part, is_normal(x), x["alpha"], x["depth"], 0));
}

Confirmation v(Arguments x) {
  const mpq_class eta(x["eta"]), poisson(x["poisson"]), t1 = 1 / (2 * (1 - poisson));
  const bool normal = is_normal(x);
  Split sum = sum_of(Component::v, normal, x["alpha"], x["depth"], poisson);
  if (normal) {
    sum.add(1 - t1, I4(eta)).add(-t1, I5(eta));
  } else {
    sum.add(-1, I6_eta(eta)).add(t1, I7(eta));
  }
  return over_pi(sum);
}

Confirmation u(Arguments x) {
  return over_pi(sum_of(Component::u, is_normal(x), x["alpha"], x["depth"], mpq_class(x["poisson"])));
}

}  // namespace

Methods sheet_methods() {
  return {
      {"root.re", [](Arguments x) { return root_part(pole_of(x).z.real()); }},
      {"root.im", [](Arguments x) { return root_part(pole_of(x).z.imag()); }},
      {"residue", residue},
      {"I1", [](Arguments x) { return kernel(I1(x["alpha"])); }},
      {"I2",
       [](Arguments x) {
         return confirmation("pi/2 sign", Split{2 * sgn(mpq_class(x["alpha"])), 0, 0}.value(),
                             Float("1e-95"));
       }},
      {"I3", [](Arguments x) { return kernel(I3(x["alpha"])); }},
      {"I4", [](Arguments x) { return kernel(I4(x["eta"])); }},
      {"I5", [](Arguments x) { return kernel(I5(x["eta"])); }},
      {"I6", [](Arguments x) { return kernel(I6_sum(x["alpha"], x["eta"])); }},
      {"I7", [](Arguments x) { return kernel(I7(x["eta"])); }},
      {"F1",
       [](Arguments x) {
         const Compliances c(1, x["poisson"]);
         return displacement(F1_sum(c, x["eta"]), c.normal);
       }},
      {"F2",
       [](Arguments x) {
         return F2({1, x["poisson"]}, x["eta"]);
       }},
      {"un", [](Arguments x) { return displacement(Split{}.add(Compliances(x).normal, I1(x["alpha"]))); }},
      {"us", [](Arguments x) { return displacement(us_sum(Compliances(x), x["alpha"])); }},
      {"vn", [](Arguments x) { return vn(Compliances(x), x["alpha"], x["eta"]); }},
      {"vs", [](Arguments x) { return vs(Compliances(x), x["alpha"], x["eta"]); }},
      {"un.slope", [](Arguments x) { return displacement(I1(x["alpha"], order_of(x))); }},
      {"vn.slope", [](Arguments x) { return displacement(I3(x["alpha"], order_of(x))); }},
      {"vs.slope",
       [](Arguments x) {
         const int order = order_of(x);
         return displacement(I1(x["alpha"], order).add(-1, I3(x["alpha"], order - 1)));
       }},
      {"sheet.sx", [](Arguments x) { return stress(Component::sx, x); }},
      {"sheet.sy", [](Arguments x) { return stress(Component::sy, x); }},
      {"sheet.txy", [](Arguments x) { return stress(Component::txy, x); }},
      {"sheet.u", u},
      {"sheet.v", v}};
}

}  // namespace nipref::verify::confirm
