#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <functional>
#include <vector>

#include <nipref/verify/golden/confirm/history.hpp>

namespace nipref::verify::confirm {
namespace {

using boost::math::quadrature::gauss;

/// The Chebyshev interpolant of a function on [0, 3].
class Interpolant {
 public:
  explicit Interpolant(const std::function<Float(const Float& x)>& f) {
    std::vector<Float> values;
    for (int k = 0; k < points; ++k)
      values.push_back(f(Float(far) / 2 * (1 + cos(pi<Float>() * (2 * k + 1) / (2 * points)))));
    for (int n = 0; n < points; ++n) {
      Float sum = 0;
      for (int k = 0; k < points; ++k)
        sum += values[static_cast<std::size_t>(k)] * cos(pi<Float>() * n * (2 * k + 1) / (2 * points));
      coefficients_.push_back(2 * sum / points);
    }
    coefficients_[0] /= 2;
  }

  [[nodiscard]] Float at(const Float& x) const {
    const Float u = 2 * x / far - 1, twice = 2 * u;
    Float last = 0, before = 0;
    for (std::size_t n = coefficients_.size() - 1; n > 0; --n) {
      const Float next = coefficients_[n] + twice * last - before;
      before = last;
      last = next;
    }
    return coefficients_[0] + u * last - before;
  }

 private:
  static constexpr int points =
      180;  // the nearest singularity, +-i, is on Bernstein's ellipse of parameter 2.4
  std::vector<Float> coefficients_;
};

mpq_class exact(const Float& x) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.backend().data());
  return value;
}

/// I1 + ln |w|, or the odd kernel over w.
const Interpolant& smooth_part(Remembered kernel) {
  static const Interpolant I1([](const Float&w) { return Float(kernel_I1(exact(w)).value() + log(w)); }),
      I3([](const Float&w) { return Float(kernel_I3(exact(w)).value() / w); }),
      I4([](const Float&w) { return Float(kernel_I4(exact(w)).value() / w); }),
      I5([](const Float&w) { return Float(kernel_I5(exact(w)).value() / w); });
  switch (kernel) {
    case Remembered::I1:
      return I1;
    case Remembered::I3:
      return I3;
    case Remembered::I4:
      return I4;
    default:
      return I5;
  }
}

Complex Pole::*residue_of(Remembered kernel) {
  switch (kernel) {
    case Remembered::I1:
      return &Pole::I1;
    case Remembered::I3:
      return &Pole::I3;
    case Remembered::I4:
      return &Pole::I4;
    default:
      return &Pole::I5;
  }
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

/// int f(x) piece.left(x) dx for a real f.
Complex by_gauss(const std::function<Float(const Float&)>& f, const Piece& piece, const Float& a,
                 const Float& b, bool coarse) {
  const bool swings = piece.rate.imag() != 0;
  const auto part = [&](auto part_of) {
    const auto integrand = [&](const Float& x) -> Float { return f(x) * part_of(piece.left(x)); };
    return coarse ? gauss<Float, 40>::integrate(integrand, a, b)
                  : gauss<Float, 52>::integrate(integrand, a, b);
  };
  const Float real = part([](const Complex& z) -> Float { return z.real(); });
  return {real, swings ? part([](const Complex& z) -> Float { return z.imag(); }) : Float(0)};
}

/// The same of f = -ln x from 0 to `end` by the substitution x = end e^(-v), for x down to 10^-70 of `end`.
Complex logarithm_at_zero(const Piece& piece, const Float& end, bool coarse) {
  Complex sum = 0;
  const auto part = [&](int v, auto part_of) {
    const auto integrand = [&](const Float& u) -> Float {
      const Float x = end * exp(-u);
      return -log(x) * x * part_of(piece.left(x));
    };
    return coarse ? gauss<Float, 40>::integrate(integrand, Float(v), Float(v + 4))
                  : gauss<Float, 52>::integrate(integrand, Float(v), Float(v + 4));
  };
  for (int v = 0; v < 176; v += 4) {
    sum += Complex(part(v, [](const Complex& z) -> Float { return z.real(); }),
                   part(v, [](const Complex& z) -> Float { return z.imag(); }));
  }
  return sum;
}

/// The integral over a piece with 0 <= near < distant <= 3.
Complex close_piece(Remembered kernel, Piece piece, bool coarse) {
  const Float fades = piece.rate.real(), turns = abs(piece.rate);
  if (fades * (piece.distant - piece.near) > forgotten) {
    if (piece.freshest_near) {
      piece.distant = piece.near + forgotten / fades;
    } else {
      // The memory still decays from the distant end on.
      piece.near = piece.distant - forgotten / fades;
    }
  }
  const bool has_logarithm = kernel == Remembered::I1;
  const Interpolant& smooth = smooth_part(kernel);
  const auto remembered = [&](const Float& x) -> Float {
    return has_logarithm ? Float(smooth.at(x) - log(x)) : Float(smooth.at(x) * x - pi<Float>() / 4);
  };
  const auto without_logarithm = [&](const Float& x) -> Float { return smooth.at(x); };
  Complex sum = 0;
  Float from = piece.near;
  while (from < piece.distant) {
    Float to = std::min<Float>(piece.distant, from + Float(1) / 2);
    if (turns > 0) to = std::min<Float>(to, from + 8 / turns);
    if (has_logarithm && from > 0) to = std::min<Float>(to, 2 * from);
    if (has_logarithm && from == 0) {
      sum += by_gauss(without_logarithm, piece, from, to, coarse) + logarithm_at_zero(piece, to, coarse);
    } else {
      sum += by_gauss(remembered, piece, from, to, coarse);
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
Complex far_piece(Remembered kernel, const Piece& piece, bool endless) {
  const bool is_odd = kernel != Remembered::I1;
  const Complex i(Float(0), Float(1));
  Complex sum = 0;
  for (std::size_t n = poles; n >= 1; --n) {
    const Complex residue = pole(n).*residue_of(kernel), z = pole(n).z;
    const Complex wave = residue * of_wave(z, piece, endless);
    const Complex mirrored = conj(residue) * of_wave(Complex(-conj(z)), piece, endless);
    sum += is_odd ? Complex(wave + mirrored) : Complex((wave - mirrored) * i);
  }
  return sum * pi<Float>();
}

/// The integral over the distances from `near` to `distant`, or to infinity without `distant`, on one side of the load.
Complex one_side(Remembered kernel, const mpq_class& near, const std::optional<mpq_class>& distant,
                 bool freshest_near, const Complex& rate, bool coarse) {
  const mpq_class border = far;
  const bool goes_far = !distant || *distant > border;
  Complex sum = 0;
  const auto freshest_at = [&] { return to_number<Float>(freshest_near ? near : *distant); };
  if (near < border) {
    const mpq_class end = goes_far ? border : *distant;
    const Piece piece{to_number<Float>(near), to_number<Float>(end), freshest_near, rate};
    // The piece counts the decay from its own end, so that the decay up to this end is a factor.
    const Complex faded =
        freshest_near ? Complex(1) : exp(Complex(-rate * Float(freshest_at() - piece.distant)));
    sum += faded * close_piece(kernel, piece, coarse);
  }
  if (goes_far) {
    const mpq_class begin = std::max(near, border);
    const Piece piece{to_number<Float>(begin), distant ? to_number<Float>(*distant) : Float(0), freshest_near,
                      rate};
    const Complex faded =
        freshest_near ? exp(Complex(-rate * Float(piece.near - freshest_at()))) : Complex(1);
    sum += faded * far_piece(kernel, piece, !distant);
  }
  return sum;
}

}  // namespace

Complex history(Remembered kernel, const mpq_class& from, const std::optional<mpq_class>& to,
                const Complex& rate, bool coarse) {
  Complex sum = 0;
  const int parity = kernel == Remembered::I1 ? 1 : -1;
  if (from < 0) {
    const mpq_class end = to && *to < 0 ? *to : mpq_class(0);
    sum += parity * one_side(kernel, -end, mpq_class(-from), false, rate, coarse);
  }
  if (!to || *to > 0) {
    const mpq_class begin = from > 0 ? from : mpq_class(0);
    const Complex faded = exp(Complex(-rate * to_number<Float>(mpq_class(begin - from))));
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
