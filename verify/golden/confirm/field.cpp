#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

/// alpha >= 0 and 0 <= depth <= 1.
struct InnerPoint {
  Float alpha, depth;
};

/// A node of the double exponential rule with 2 sinh z/S - 2 e^-z and 2 cosh z/S - 2 e^-z.
struct Rests {
  Float z, weight, sine, cosine;
};

const std::vector<Rests>& rests() {
  static const auto all =
      double_exponential_rule<Rests>(250, [](const Float& z, const Float& weight) -> Rests {
        const Float q = exp(-2 * z), whole = 4 * z * q - expm1(-4 * z), scale = -2 * exp(-3 * z) / whole;
        return {z, weight, scale * (1 + 4 * z - q), scale * (4 * z - 1 - q)};
      });
  return all;
}

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

/// pi times the quantity; for v the part that does not depend on eta.
Split near_sum(Component part, bool normal, const InnerPoint& at, const Float& t1) {
  const bool sine = is_sine(part, normal), twofold = part == Component::v && !normal;
  Split sum = integral(rests(), [&](const Rests& node) -> Float {
    const Float angle = at.alpha * node.z;
    Float value = integrand<Float>(part, normal, at.depth, t1, node.z, node.sine, node.cosine) *
                  (sine ? sin(angle) : cos(angle));
    if (twofold) value -= node.cosine / node.z;
    return node.weight * value;
  });
  sum.rest += half_planes(part, normal, at, t1);
  if (twofold) sum.add(1, kernel_I6_eta(0));
  sum.error += abs(sum.rest) * Float("1e-90");
  return sum;
}

/// The size of the residues of what is transformed here.
constexpr int residues = 2000;

Split far_sum(Component part, bool normal, const InnerPoint& at, const mpq_class& alpha, const Float& t1) {
  Split value = around_poles(at.alpha, is_sine(part, normal), residues, [&](const Pole& pole) {
    return integrand<Complex>(part, normal, at.depth, t1, pole.z, pole.I7, pole.I5);
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
    sum.add(1 - t1, kernel_I4(eta)).add(-t1, kernel_I5(eta));
  } else {
    sum.add(-1, kernel_I6_eta(eta)).add(t1, kernel_I7(eta));
  }
  return over_pi(sum);
}

Confirmation u(Arguments x) {
  return over_pi(sum_of(Component::u, is_normal(x), x["alpha"], x["depth"], mpq_class(x["poisson"])));
}

/// A first derivative of a face: -1/pi times the integral of 2 sinh z/S or 2 cosh z/S, times sinh z or cosh z, times the
/// sine or the cosine of alpha z.
struct FaceSlope {
  bool of_sinh, rises, sine;
};
constexpr FaceSlope un_slope{true, true, true}, vn_slope{true, false, false}, vs_slope{false, false, true};

Split near_face(const FaceSlope& slope, bool second, const Float& a) {
  Split sum = integral(rests(), [&](const Rests& node) -> Float {
    const Float angle = a * node.z;
    const Float wave = second ? Float(node.z * (slope.sine ? cos(angle) : Float(-sin(angle))))
                              : Float(slope.sine ? sin(angle) : cos(angle));
    return -node.weight * (slope.of_sinh ? node.sine : node.cosine) *
           (slope.rises ? sinh(node.z) : cosh(node.z)) * wave;
  });
  // The same with 2 e^-z in place of the symbol: of e^0 and, with the sign of sinh or cosh, of e^-2z.
  const Float R2 = 4 + a * a, other = slope.rises ? -1 : 1;
  if (slope.sine) {
    sum.rest +=
        second ? Float(1 / (a * a) - other * (4 - a * a) / (R2 * R2)) : Float(-1 / a - other * a / R2);
  } else {
    sum.rest += other * (second ? Float(4 * a / (R2 * R2)) : Float(-2 / R2));
  }
  sum.error += abs(sum.rest) * Float("1e-90");
  return sum;
}

Split far_face(const FaceSlope& slope, bool second, const Float& a) {
  Split value = around_poles(a, slope.sine, residues, [&](const Pole& pole) {
    const Complex &z = pole.z, turned = second ? Complex(-z.imag(), z.real()) : Complex(1);
    return Complex(-(slope.of_sinh ? pole.I7 : pole.I5) * (slope.rises ? sinh(z) : cosh(z)) * turned);
  });
  if (!slope.of_sinh && !second) value.rest -= pi() / 4;
  return value;
}

Confirmation on_face(const FaceSlope& slope, Arguments x) {
  const mpq_class alpha(x["alpha"]);
  const Float a = to_number(abs(alpha));
  const bool second = x["order"] != 0, odd = slope.sine != second;
  return over_pi(Split{}.add(odd ? sgn(alpha) : 1,
                             abs(alpha) < far ? near_face(slope, second, a) : far_face(slope, second, a)));
}

}  // namespace

Methods field_methods() {
  return {{"un.slope", [](Arguments x) { return on_face(un_slope, x); }},
          {"vn.slope", [](Arguments x) { return on_face(vn_slope, x); }},
          {"vs.slope", [](Arguments x) { return on_face(vs_slope, x); }},
          {"sheet.sx", [](Arguments x) { return stress(Component::sx, x); }},
          {"sheet.sy", [](Arguments x) { return stress(Component::sy, x); }},
          {"sheet.txy", [](Arguments x) { return stress(Component::txy, x); }},
          {"sheet.u", u},
          {"sheet.v", v}};
}

}  // namespace nipref::verify::confirm
