#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

/// The derivative of cos or sin of this order, 0 to 2, at `angle`.
Float derivative(const Float& angle, bool is_sine, int order) {
  const Float wave = is_sine == (order % 2 == 0) ? sin(angle) : cos(angle);
  return order == 2 || (order == 1 && !is_sine) ? Float(-wave) : wave;
}

/// The integral along the real axis of the symbol times cos(x z) or sin(x z), differentiated `order` times by x.
template <class Symbol>
Split along_axis(const mpq_class& x, bool is_sine, int order, Symbol symbol) {
  const Float at = to_number(x);
  return integral([&](const Node& node) -> Float {
    const Float turned = symbol(node) * derivative(at * node.z, is_sine, order);
    return order == 0 ? turned : order == 1 ? Float(turned * node.z) : Float(turned * node.z * node.z);
  });
}

/// A kernel whose symbol can be integrated as it is.
template <bool is_odd, class Symbol>
constexpr SymbolTransform plain(Symbol) {
  return {is_odd, 0, [](const Pole& at) -> Complex { return Symbol()(at); },
          [](const mpq_class& x, int order) { return along_axis(x, is_odd, order, Symbol()); }};
}

/// An approximation of the n-th root by Newton's iteration in double: the centre of a circle around the root.
std::complex<double> near_root(std::size_t n) {
  const double y = (static_cast<double>(n) - 0.25) * std::numbers::pi;
  std::complex<double> z(std::acosh(2 * y) / 2, y);
  for (int k = 0; k < 20; ++k) z -= (std::sinh(2.0 * z) + 2.0 * z) / (2.0 * std::cosh(2.0 * z) + 2.0);
  return z;
}

/// I1 as - ln tanh(pi alpha/4) - int 2 tanh x cos(alpha x)/S dx.
Split I1_near(const mpq_class& alpha, int order) {
  Split sum =
      along_axis(alpha, false, order, [](const Node& at) -> Float { return -at.unit * at.sine / at.cosine; });
  const Float half = pi() / 2, angle = half * to_number(alpha);
  sum.rest += order == 0   ? Float(-log(tanh(abs(angle) / 2)))
              : order == 1 ? Float(-half / sinh(angle))
                           : Float(half * half * cosh(angle) / (sinh(angle) * sinh(angle)));
  return sum;
}

/// I6_eta as int 2 cosh x (cos(eta x) - cos(3 x))/(x S) dx + I6_eta(3).
Split I6_eta_near(const mpq_class& eta, int) {
  const Float at = to_number(eta), half_sum = (far + at) / 2, half_difference = (far - at) / 2;
  return integral([&](const Node& node) -> Float {
           return 2 * node.cosine / node.z * sin(half_sum * node.z) * sin(half_difference * node.z);
         })
      .add(1, I6_eta(far));
}

/// I6_alpha as I1 + int 2 (cos(alpha x) - cosh x cos(3 x))/(x S) dx + I6_eta(3), without cancellation at small x.
Split I6_alpha_near(const mpq_class& alpha, int) {
  const Float at = to_number(alpha), half_sum = (far + at) / 2, half_difference = (far - at) / 2;
  return integral([&](const Node& node) -> Float {
           const Float lifted = sinh(node.z / 2);
           return 2 * node.unit / node.z *
                  (sin(half_sum * node.z) * sin(half_difference * node.z) -
                   cos(far * node.z) * lifted * lifted);
         })
      .add(1, I1_near(alpha, 0))
      .add(1, I6_eta(far));
}

}  // namespace

const SymbolTransform I1{
    false, 0, [](const Pole& at) -> Complex { return at.sine * at.sine / (at.unit * at.z); }, I1_near};
const SymbolTransform I3 = plain<true>([](const auto& at) { return at.unit; });
const SymbolTransform I4 = plain<true>([](const auto& at) { return at.sine / at.z; });
const SymbolTransform I5 = plain<true>([](const auto& at) { return at.cosine; });
const SymbolTransform I7 = plain<false>([](const auto& at) { return at.sine; });
const SymbolTransform I6_alpha{
    false, -1, [](const Pole& at) -> Complex { return at.cosine * at.cosine / (at.unit * at.z); },
    I6_alpha_near};
const SymbolTransform I6_eta{false, -1, [](const Pole& at) -> Complex { return at.cosine / at.z; },
                             I6_eta_near};

// Node j is at t = j/256; the coarse rule has the nodes of even j. For |x| <= 3 the integrands are analytic and bounded
// in the strip |Im t| < 0.3.
const std::vector<Node>& nodes() {
  static const std::vector<Node> all = [] {
    const Float step = Float(1) / 256;
    std::vector<Node> made;
    for (int j = -1400; j <= 1600; ++j) {
      const Float t = j * step, z = exp(t - exp(-t)), weight = step * z * (1 + exp(-t));
      if (z > 400) break;
      const Float unit = 2 * weight / (sinh(2 * z) + 2 * z), q = exp(-2 * z);
      const Float scale = -2 * weight * exp(-3 * z) / (4 * z * q - expm1(-4 * z));
      made.push_back(
          {{z, unit, unit * sinh(z), unit * cosh(z)}, scale * (1 + 4 * z - q), scale * (4 * z - 1 - q)});
    }
    return made;
  }();
  return all;
}

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
    const Complex unit = 2 * arm / (Float(points) * (2 * sine * cosine + 2 * z));
    moment += unit * arm;
    pole.unit += unit;
    pole.sine += unit * sine;
    pole.cosine += unit * cosine;
  }
  pole.z = centre + moment / pole.unit;
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

Split SymbolTransform::operator()(const mpq_class& x, int order) const {
  const mpq_class size = abs(x);
  if (size < far) return near(x, order);
  Split value = around_poles(to_number(size), is_odd, order == 0 ? 8 : 2000, [&](const Pole& at) {
    const Complex turn(-at.z.imag(), at.z.real());
    return order == 0   ? residue(at)
           : order == 1 ? Complex(residue(at) * turn)
                        : Complex(residue(at) * turn * turn);
  });
  if (order == 0) value.quarters = is_odd ? mpq_class(1) : mpq_class(growth * size);
  return Split{}.add(is_odd == (order % 2 == 0) ? sgn(x) : 1, value);
}

}  // namespace nipref::verify::confirm
