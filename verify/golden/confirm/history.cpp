#include <boost/math/quadrature/gauss.hpp>

#include <nipref/verify/golden/confirm/interpolant.hpp>
#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

using boost::math::quadrature::gauss;

/// The smooth part of a kernel for |w| < 3: I1 + ln |w|, or an odd kernel over w. The nearest singularities, +-i, are
/// on Bernstein's ellipse of parameter 2.4.
const Interpolant& smooth_part(const SymbolTransform& kernel) {
  static const auto made = [](const SymbolTransform& of) {
    return Interpolant(0, far, 180, [of](const Float& w) {
      const Float value = of(exactly(w)).value();
      return of.is_odd ? Float(value / w) : Float(value + log(w));
    });
  };
  static const std::map<const SymbolTransform*, Interpolant> all{
      {&I1, made(I1)}, {&I3, made(I3)}, {&I4, made(I4)}, {&I5, made(I5)}};
  return all.at(&kernel);
}

/// A memory is neglected once it has decayed by the factor e^-forgotten.
constexpr int forgotten = 200;

/// The integrals of history() over the distance x from the load on one side of it: w = x on side 1, w = -x on side -1.
struct History {
  const SymbolTransform& kernel;
  Float from;
  Complex rate;
  bool coarse;

  /// The factor by which the memory of the distance x has decayed.
  [[nodiscard]] Complex kept(int side, const Float& x) const {
    return exp(Complex(-rate * Float(side * x - from)));
  }

  [[nodiscard]] Complex by_gauss(const auto& f, const Float& a, const Float& b) const {
    const auto part = [&](auto part_of) {
      const auto integrand = [&](const Float& x) -> Float { return part_of(f(x)); };
      return coarse ? gauss<Float, 40>::integrate(integrand, a, b)
                    : gauss<Float, 52>::integrate(integrand, a, b);
    };
    const Float real = part([](const Complex& z) -> Float { return z.real(); });
    return {real, rate.imag() == 0 ? Float(0) : part([](const Complex& z) -> Float { return z.imag(); })};
  }

  /// int -ln x kept(x) dx over 0 < x < end, by the substitution x = end e^(-u) and without the part below end e^-176.
  [[nodiscard]] Complex logarithm_at_zero(int side, const Float& end) const {
    Complex sum = 0;
    const auto integrand = [&](const Float& u) -> Complex {
      const Float x = end * exp(-u);
      return Float(-log(x) * x) * kept(side, x);
    };
    for (int v = 0; v < 176; v += 4) sum += by_gauss(integrand, Float(v), Float(v + 4));
    return sum;
  }

  /// The integral from `near` to `distant`, 0 <= near < distant <= 3.
  [[nodiscard]] Complex close(int side, Float near, Float distant) const {
    const Float fades = rate.real(), turns = abs(rate);
    if (fades * (distant - near) > forgotten) {
      if (side > 0) {
        distant = near + forgotten / fades;
      } else {
        near = distant - forgotten / fades;
      }
    }
    const Interpolant& smooth = smooth_part(kernel);
    const auto remembered = [&](const Float& x) -> Complex {
      return Float(kernel.is_odd ? smooth(x) * x - pi() / 4 : smooth(x) - log(x)) * kept(side, x);
    };
    const auto without_logarithm = [&](const Float& x) -> Complex { return smooth(x) * kept(side, x); };
    Complex sum = 0;
    while (near < distant) {
      Float to = std::min<Float>(distant, near + Float(1) / 2);
      if (turns > 0) to = std::min<Float>(to, near + 8 / turns);
      if (!kernel.is_odd && near > 0) to = std::min<Float>(to, 2 * near);
      if (!kernel.is_odd && near == 0) {
        sum += by_gauss(without_logarithm, near, to) + logarithm_at_zero(side, to);
      } else {
        sum += by_gauss(remembered, near, to);
      }
      near = to;
    }
    return sum;
  }

  /// The integral from `near` >= 3 to `end`, or to infinity without `end`: a sum over the pairs of poles z and -conj z,
  /// whose terms are conjugate but for the factor of the memory. Each term is integrated by its antiderivative.
  [[nodiscard]] Complex distant(int side, const Float& near, const std::optional<Float>& end) const {
    const Complex i(Float(0), Float(1)), turned = Float(side) * rate;
    const auto of_wave = [&](const Complex& z) -> Complex {
      const auto at = [&](const Float& x) -> Complex {
        return exp(Complex(i * z * x)) * kept(side, x) / (i * z - turned);
      };
      return end ? Complex(at(*end) - at(near)) : Complex(-at(near));
    };
    Complex sum = 0;
    for (std::size_t n = poles; n >= 1; --n) {
      const Complex residue = kernel.residue(pole(n)), z = pole(n).z;
      const Complex wave = residue * of_wave(z), mirrored = conj(residue) * of_wave(Complex(-conj(z)));
      sum += kernel.is_odd ? Complex(wave + mirrored) : Complex((wave - mirrored) * i);
    }
    return sum * pi();
  }

  /// The integral from the distance `near` to `end`, or to infinity without `end`.
  [[nodiscard]] Complex one_side(int side, const mpq_class& near, const std::optional<mpq_class>& end) const {
    const mpq_class border = far;
    Complex sum = 0;
    if (near < border) sum += close(side, to_number(near), to_number(end ? std::min(*end, border) : border));
    if (!end || *end > border)
      sum += distant(side, to_number(std::max(near, border)),
                     end ? std::optional(to_number(*end)) : std::nullopt);
    return side < 0 && kernel.is_odd ? Complex(-sum) : sum;
  }
};

}  // namespace

Complex history(const SymbolTransform& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse) {
  const History over{kernel, to_number(from), rate, coarse};
  Complex sum = 0;
  if (from < 0) sum += over.one_side(-1, to && *to < 0 ? mpq_class(-*to) : mpq_class(0), mpq_class(-from));
  if (!to || *to > 0) sum += over.one_side(1, std::max(from, mpq_class(0)), to);
  return sum;
}

LongComplex history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to,
                            const LongComplex& rate) {
  const auto over = [&](const mpq_class& length) -> LongComplex {
    const Long way = to_number<Long>(length);
    return rate == LongComplex(0) ? LongComplex(way)
                                  : LongComplex((LongComplex(1) - exp(LongComplex(-rate * way))) / rate);
  };
  LongComplex sum = 0;
  if (from < 0) sum -= over((to && *to < 0 ? *to : mpq_class(0)) - from);
  if (!to || *to > 0) {
    const mpq_class begin = from > 0 ? from : mpq_class(0);
    // At rate 0 the integral to infinity diverges. The result is the integral over a long way W from `from` on, less W.
    const LongComplex endless = rate == LongComplex(0) ? LongComplex(to_number<Long>(mpq_class(from - begin)))
                                                       : LongComplex(LongComplex(1) / rate);
    const LongComplex rest = to ? over(mpq_class(*to - begin)) : endless;
    sum += exp(LongComplex(-rate * to_number<Long>(mpq_class(begin - from)))) * rest;
  }
  return sum;
}

}  // namespace nipref::verify::confirm
