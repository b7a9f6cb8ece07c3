#include <boost/math/quadrature/gauss.hpp>

#include <nipref/verify/golden/confirm/interpolant.hpp>
#include <nipref/verify/golden/confirm/kernels.hpp>

namespace nipref::verify::confirm {
namespace {

using boost::math::quadrature::gauss;

/// I1 + ln |w|, or the odd kernel over w, for |w| < 3. The nearest singularity, +-i, is on Bernstein's ellipse of parameter
/// 2.4.
const Interpolant& smooth_part(const Remembered& kernel) {
  static const auto made = [](const Remembered& of) {
    return Interpolant(0, far, 180, [of](const Float& w) {
      const Float value = of.at(exactly(w)).value();
      return of.is_odd ? Float(value / w) : Float(value + log(w));
    });
  };
  static const std::map<Split (*)(const mpq_class&), Interpolant> all{{kernel_I1, made(remembered_I1)},
                                                                      {kernel_I3, made(remembered_I3)},
                                                                      {kernel_I4, made(remembered_I4)},
                                                                      {kernel_I5, made(remembered_I5)}};
  return all.at(kernel.at);
}

/// An interval of distances on one side of the load. The memory decays from the near end on if `freshest_near`,
/// otherwise from the distant end on.
struct Piece {
  Float near, distant;
  bool freshest_near;
  Complex rate;

  /// The factor by which the memory of x has decayed.
  [[nodiscard]] Complex left(const Float& x) const {
    return exp(Complex(-rate * (freshest_near ? Float(x - near) : Float(distant - x))));
  }
};

/// A memory is neglected where it has decayed by e to this power.
constexpr int forgotten = 200;

/// The integral of a complex function, real if its imaginary part is not wanted.
template <class Integrand>
Complex by_gauss(const Integrand& f, const Float& a, const Float& b, bool coarse, bool is_complex) {
  const auto part = [&](auto part_of) {
    const auto integrand = [&](const Float& x) -> Float { return part_of(f(x)); };
    return coarse ? gauss<Float, 40>::integrate(integrand, a, b)
                  : gauss<Float, 52>::integrate(integrand, a, b);
  };
  const Float real = part([](const Complex& z) -> Float { return z.real(); });
  return {real, is_complex ? part([](const Complex& z) -> Float { return z.imag(); }) : Float(0)};
}

/// int -ln x piece.left(x) dx from 0 to `end` by the substitution x = end e^(-v), for x down to 10^-70 of `end`.
Complex logarithm_at_zero(const Piece& piece, const Float& end, bool coarse) {
  Complex sum = 0;
  const auto integrand = [&](const Float& u) -> Complex {
    const Float x = end * exp(-u);
    return Float(-log(x) * x) * piece.left(x);
  };
  for (int v = 0; v < 176; v += 4)
    sum += by_gauss(integrand, Float(v), Float(v + 4), coarse, piece.rate.imag() != 0);
  return sum;
}

/// The integral over a piece with 0 <= near < distant <= 3.
Complex close_piece(const Remembered& kernel, Piece piece, bool coarse) {
  const Float fades = piece.rate.real(), turns = abs(piece.rate);
  if (fades * (piece.distant - piece.near) > forgotten) {
    if (piece.freshest_near) {
      piece.distant = piece.near + forgotten / fades;
    } else {
      // The memory still decays from the distant end on.
      piece.near = piece.distant - forgotten / fades;
    }
  }
  const bool has_logarithm = !kernel.is_odd;
  const Interpolant& smooth = smooth_part(kernel);
  const auto remembered = [&](const Float& x) -> Complex {
    return Float(has_logarithm ? smooth(x) - log(x) : smooth(x) * x - pi() / 4) * piece.left(x);
  };
  const auto without_logarithm = [&](const Float& x) -> Complex { return smooth(x) * piece.left(x); };
  const auto over = [&](const auto& f, const Float& a, const Float& b) {
    return by_gauss(f, a, b, coarse, piece.rate.imag() != 0);
  };
  Complex sum = 0;
  Float from = piece.near;
  while (from < piece.distant) {
    Float to = std::min<Float>(piece.distant, from + Float(1) / 2);
    if (turns > 0) to = std::min<Float>(to, from + 8 / turns);
    if (has_logarithm && from > 0) to = std::min<Float>(to, 2 * from);
    if (has_logarithm && from == 0) {
      sum += over(without_logarithm, from, to) + logarithm_at_zero(piece, to, coarse);
    } else {
      sum += over(remembered, from, to);
    }
    from = to;
  }
  return sum;
}

/// int e^(i x z) piece.left(x) dx from near to distant, or to infinity if `endless`, as the difference of its
/// antiderivative at both ends.
Complex of_wave(const Complex& z, const Piece& piece, bool endless) {
  const Complex slope =
      Complex(-z.imag(), z.real()) + (piece.freshest_near ? Complex(-piece.rate) : piece.rate);
  const auto at = [&](const Float& x) -> Complex {
    return exp(Complex(-z.imag() * x, z.real() * x)) * piece.left(x) / slope;
  };
  return endless ? Complex(-at(piece.near)) : Complex(at(piece.distant) - at(piece.near));
}

/// The integral over a piece with near >= 3, as a sum over the pairs of poles z and -conj z. The terms of a pair are
/// conjugate but for the factor of the memory.
Complex far_piece(const Remembered& kernel, const Piece& piece, bool endless) {
  const Complex i(Float(0), Float(1));
  Complex sum = 0;
  for (std::size_t n = poles; n >= 1; --n) {
    const Complex residue = pole(n).*kernel.residue, z = pole(n).z;
    const Complex wave = residue * of_wave(z, piece, endless);
    const Complex mirrored = conj(residue) * of_wave(Complex(-conj(z)), piece, endless);
    sum += kernel.is_odd ? Complex(wave + mirrored) : Complex((wave - mirrored) * i);
  }
  return sum * pi();
}

/// The integral over the distances from `near` to `distant`, or to infinity without `distant`, on one side of the load.
Complex one_side(const Remembered& kernel, const mpq_class& near, const std::optional<mpq_class>& distant,
                 bool freshest_near, const Complex& rate, bool coarse) {
  const mpq_class border = far;
  const bool goes_far = !distant || *distant > border;
  Complex sum = 0;
  const auto freshest_at = [&] { return to_number(freshest_near ? near : *distant); };
  if (near < border) {
    const mpq_class end = goes_far ? border : *distant;
    const Piece piece{to_number(near), to_number(end), freshest_near, rate};
    // The piece counts the decay from its own end, so that the decay up to this end is a factor.
    const Complex faded =
        freshest_near ? Complex(1) : exp(Complex(-rate * Float(freshest_at() - piece.distant)));
    sum += faded * close_piece(kernel, piece, coarse);
  }
  if (goes_far) {
    const mpq_class begin = std::max(near, border);
    const Piece piece{to_number(begin), distant ? to_number(*distant) : Float(0), freshest_near, rate};
    const Complex faded =
        freshest_near ? exp(Complex(-rate * Float(piece.near - freshest_at()))) : Complex(1);
    sum += faded * far_piece(kernel, piece, !distant);
  }
  return sum;
}

}  // namespace

Complex history(const Remembered& kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse) {
  Complex sum = 0;
  const int parity = kernel.is_odd ? -1 : 1;
  if (from < 0) {
    const mpq_class end = to && *to < 0 ? *to : mpq_class(0);
    sum += parity * one_side(kernel, -end, mpq_class(-from), false, rate, coarse);
  }
  if (!to || *to > 0) {
    const mpq_class begin = from > 0 ? from : mpq_class(0);
    const Complex faded = exp(Complex(-rate * to_number(mpq_class(begin - from))));
    sum += faded * one_side(kernel, begin, to, true, rate, coarse);
  }
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
    // At rate 0 the integral of the two parts to infinity differs from that of sign w by a constant, which is left out.
    const LongComplex endless = rate == LongComplex(0) ? LongComplex(to_number<Long>(mpq_class(from - begin)))
                                                       : LongComplex(LongComplex(1) / rate);
    const LongComplex rest = to ? over(mpq_class(*to - begin)) : endless;
    sum += exp(LongComplex(-rate * to_number<Long>(mpq_class(begin - from)))) * rest;
  }
  return sum;
}

}  // namespace nipref::verify::confirm
