#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

struct Node {
  Float x, weight;
  Float T, I3, I4, I5, I7, I6_alpha, I6_eta;  ///< weight times symbol
};

const std::vector<Node>& nodes() {
  static const auto all = double_exponential_rule<Node>(400, [](const Float& x, const Float& weight) -> Node {
    const Float sine = sinh(x), cosine = cosh(x), S = sinh(2 * x) + 2 * x, unit = 2 * weight / S;
    return {x,           weight,   unit * sine / cosine, unit, unit * sine / x, unit * cosine,
            unit * sine, unit / x, unit * cosine / x};
  });
  return all;
}

Split even_far(const mpq_class& x, Complex Pole::*residue) {
  return around_poles(to_number(abs(x)), false, 8, [=](const Pole& at) { return at.*residue; });
}

Split odd_far(const mpq_class& x, Complex Pole::*residue) {
  return Split{sgn(x), 0, 0}.add(
      sgn(x), around_poles(to_number(abs(x)), true, 8, [=](const Pole& at) { return at.*residue; }));
}

bool is_far(const mpq_class& x) { return abs(x) >= far; }

Split odd(const mpq_class& x, Float Node::*symbol, Complex Pole::*residue) {
  if (is_far(x)) return odd_far(x, residue);
  const Float at = to_number(x);
  return integral(nodes(), [&](const Node& node) -> Float { return node.*symbol * sin(at * node.x); });
}

/// An approximate root by Newton's iteration in double, which is only the centre of a circle around the root.
std::complex<double> near_root(std::size_t n) {
  const double y = (static_cast<double>(n) - 0.25) * std::numbers::pi;
  std::complex<double> z(std::acosh(2 * y) / 2, y);
  for (int k = 0; k < 20; ++k) z -= (std::sinh(2.0 * z) + 2.0 * z) / (2.0 * std::cosh(2.0 * z) + 2.0);
  return z;
}

/// I1 as - ln tanh(pi alpha/4) - int 2 tanh x cos(alpha x)/S dx.
Split I1_near(const mpq_class& alpha) {
  const Float at = abs(to_number(alpha));
  Split sum = integral(nodes(), [&](const Node& node) -> Float { return -node.T * cos(at * node.x); });
  sum.rest -= log(tanh(pi() * at / 4));
  return sum;
}

/// int 2 cosh x (cos(eta x) - cos(3 x))/(x S) dx.
Split eta_from_far(const mpq_class& eta) {
  const Float at = to_number(eta), half_sum = (far + at) / 2, half_difference = (far - at) / 2;
  return integral(nodes(), [&](const Node& node) -> Float {
    return 2 * node.I6_eta * sin(half_sum * node.x) * sin(half_difference * node.x);
  });
}

/// int 2 (cos(alpha x) - cosh x cos(3 x))/(x S) dx, without cancellation at small x.
Split alpha_from_far(const mpq_class& alpha) {
  const Float at = to_number(alpha), half_sum = (far + at) / 2, half_difference = (far - at) / 2;
  return integral(nodes(), [&](const Node& node) -> Float {
    const Float lifted = sinh(node.x / 2);
    return 2 * node.I6_alpha *
           (sin(half_sum * node.x) * sin(half_difference * node.x) - cos(far * node.x) * lifted * lifted);
  });
}

}  // namespace

Split& Split::add(const mpq_class& factor, const Split& term) {
  const Float by = to_number(factor);
  quarters += factor * term.quarters;
  rest += by * term.rest;
  error += abs(by) * term.error;
  return *this;
}

Float Split::value() const { return to_number(quarters) * pi() / 4 + rest; }

Pole pole_by_circle(std::size_t n) {
  constexpr int points = 128;
  const std::complex<double> near = near_root(n);
  const Complex centre(Float(near.real()), Float(near.imag()));
  const Float radius = Float(1) / 4;
  Pole pole{};
  Complex moment = 0;
  for (int k = 0; k < points; ++k) {
    const Float angle = 2 * pi() * k / points;
    const Complex arm(radius * cos(angle), radius * sin(angle)), z = centre + arm;
    const Complex sine = sinh(z), cosine = cosh(z);
    const Complex unit = 2 * arm / (Float(points) * (2 * sine * cosine + 2 * z));  // of 2/S
    moment += unit * arm;
    pole.I1 += unit * sine * sine / z;
    pole.I3 += unit;
    pole.I4 += unit * sine / z;
    pole.I5 += unit * cosine;
    pole.I7 += unit * sine;
    pole.I6_alpha += unit / z;
    pole.I6_eta += unit * cosine / z;
  }
  pole.z = centre + moment / pole.I3;
  return pole;
}

const Pole& pole(std::size_t n) {
  static const std::vector<Pole> all = [] {
    std::vector<Pole> made;
    for (std::size_t k = 1; k <= poles; ++k) made.push_back(pole_by_circle(k));
    return made;
  }();
  return all.at(n - 1);
}

Split around_poles(const Float& x, bool is_sine, int size,
                   const std::function<Complex(const Pole& at)>& residue) {
  Complex sum = 0;
  for (std::size_t n = poles; n >= 1; --n) {
    const Pole& at = pole(n);
    sum += residue(at) * exp(Complex(-at.z.imag() * x, at.z.real() * x));
  }
  return {0, 2 * pi() * (is_sine ? sum.real() : Float(-sum.imag())),
          size * exp(-(2 * static_cast<int>(poles) + 1) * pi() / 2 * x) + abs(sum) * Float("1e-90")};
}

Split kernel_I1(const mpq_class& alpha) {
  return is_far(alpha) ? even_far(alpha, &Pole::I1) : I1_near(alpha);
}

Split kernel_I2(const mpq_class& alpha) { return {2 * sgn(alpha), 0, 0}; }
Split kernel_I3(const mpq_class& alpha) { return odd(alpha, &Node::I3, &Pole::I3); }
Split kernel_I4(const mpq_class& eta) { return odd(eta, &Node::I4, &Pole::I4); }
Split kernel_I5(const mpq_class& eta) { return odd(eta, &Node::I5, &Pole::I5); }

Split kernel_I7(const mpq_class& eta) {
  if (is_far(eta)) return even_far(eta, &Pole::I7);
  const Float at = to_number(eta);
  return integral(nodes(), [&](const Node& node) -> Float { return node.I7 * cos(at * node.x); });
}

Split kernel_I6_eta(const mpq_class& eta) {
  if (!is_far(eta)) return eta_from_far(eta).add(1, kernel_I6_eta(far));
  Split value = even_far(eta, &Pole::I6_eta);
  value.quarters = -abs(eta);
  return value;
}

Split kernel_I6_alpha(const mpq_class& alpha) {
  if (!is_far(alpha)) {
    Split value = I1_near(alpha);
    return value.add(1, alpha_from_far(alpha)).add(1, kernel_I6_eta(far));
  }
  // The symbol is 2 cosh^2 z/(z S) = 2/(z S) + 2 sinh^2 z/(z S).
  Split value = even_far(alpha, &Pole::I6_alpha).add(1, even_far(alpha, &Pole::I1));
  value.quarters = -abs(alpha);
  return value;
}

}  // namespace nipref::verify::confirm
