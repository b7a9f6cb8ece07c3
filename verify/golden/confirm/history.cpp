#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <functional>
#include <vector>

#include <nipref/verify/golden/confirm/history.hpp>

namespace nipref::verify::confirm {
namespace {

using boost::math::quadrature::gauss;

/// A function on [0, 3] by its values at Chebyshev points.
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
  static constexpr int points = 180;  // the nearest singularity, at +-i, is on the ellipse of 2.4
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

/// A piece of the way on one side of the load, by distances from it; the memory fades towards `fades_to_far` or
/// away from it, counted from the end where it is freshest.
struct Piece {
  Float near, distant;
  bool freshest_near;
  Float rate;

  [[nodiscard]] Float age(const Float& x) const {
    return rate * (freshest_near ? Float(x - near) : Float(distant - x));
  }
};

/// Of what is smaller than this part of the freshest nothing is left.
constexpr int forgotten = 200;

Float by_gauss(const std::function<Float(const Float&)>& f, const Float& a, const Float& b, bool coarse) {
  return coarse ? gauss<Float, 40>::integrate(f, a, b) : gauss<Float, 52>::integrate(f, a, b);
}

/// Of -ln x from 0 on, where the panels would never end: x = end e^(-v), as far as 10^-70 of it.
Float logarithm_at_zero(const Piece& piece, const Float& end, bool coarse) {
  Float sum = 0;
  for (int v = 0; v < 176; v += 4) {
    sum += by_gauss(
        [&](const Float& u) -> Float {
          const Float x = end * exp(-u);
          return -log(x) * x * exp(-piece.age(x));
        },
        Float(v), Float(v + 4), coarse);
  }
  return sum;
}

/// Within 3 of the load, 0 <= near < distant <= 3.
Float close_piece(Remembered kernel, Piece piece, bool coarse) {
  if (piece.rate * (piece.distant - piece.near) > forgotten) {
    if (piece.freshest_near) {
      piece.distant = piece.near + forgotten / piece.rate;
    } else {
      // The ages still count from the far end.
      piece.near = piece.distant - forgotten / piece.rate;
    }
  }
  const bool has_logarithm = kernel == Remembered::I1;
  const Interpolant& smooth = smooth_part(kernel);
  const auto remembered = [&](const Float& x) -> Float {
    const Float value =
        has_logarithm ? Float(smooth.at(x) - log(x)) : Float(smooth.at(x) * x - pi<Float>() / 4);
    return value * exp(-piece.age(x));
  };
  const auto without_logarithm = [&](const Float& x) -> Float { return smooth.at(x) * exp(-piece.age(x)); };
  Float sum = 0, from = piece.near;
  while (from < piece.distant) {
    Float to = std::min<Float>(piece.distant, from + Float(1) / 2);
    if (piece.rate > 0) to = std::min<Float>(to, from + 8 / piece.rate);
    if (has_logarithm && from > 0) to = std::min<Float>(to, 2 * from);
    if (has_logarithm && from == 0) {
      sum += by_gauss(without_logarithm, from, to, coarse) + logarithm_at_zero(piece, to, coarse);
    } else {
      sum += by_gauss(remembered, from, to, coarse);
    }
    from = to;
  }
  return sum;
}

/// int e^(i x z) e^(-age) dx over near <= x <= distant (none: infinity), as parts at the two ends.
Complex of_wave(const Complex& z, const Piece& piece, bool endless) {
  const Complex slope =
      Complex(-z.imag(), z.real()) + Complex(piece.freshest_near ? Float(-piece.rate) : piece.rate);
  const auto at = [&](const Float& x) -> Complex {
    return exp(Complex(-z.imag() * x - piece.age(x), z.real() * x)) / slope;
  };
  return endless ? Complex(-at(piece.near)) : Complex(at(piece.distant) - at(piece.near));
}

/// Beyond 3.
Float far_piece(Remembered kernel, const Piece& piece, bool endless) {
  Complex sum = 0;
  for (std::size_t n = poles; n >= 1; --n)
    sum += pole(n).*residue_of(kernel) * of_wave(pole(n).z, piece, endless);
  return kernel == Remembered::I1 ? Float(-2 * pi<Float>() * sum.imag())
                                  : Float(2 * pi<Float>() * sum.real());
}

/// One side of the load: distances from `near` to `distant` (none: infinity); freshest at the near end or at the other.
Float one_side(Remembered kernel, const mpq_class& near, const std::optional<mpq_class>& distant,
               bool freshest_near, const mpq_class& rate, bool coarse) {
  const Float rho = to_number<Float>(rate);
  const mpq_class border = far;
  const bool goes_far = !distant || *distant > border;
  Float sum = 0;
  const auto freshest_at = [&] { return to_number<Float>(freshest_near ? near : *distant); };
  if (near < border) {
    const mpq_class end = goes_far ? border : *distant;
    const Piece piece{to_number<Float>(near), to_number<Float>(end), freshest_near, rho};
    // Counted from the piece's own end: what has faded until there is a factor.
    const Float faded = freshest_near ? Float(1) : Float(exp(-rho * (freshest_at() - piece.distant)));
    sum += faded * close_piece(kernel, piece, coarse);
  }
  if (goes_far) {
    const mpq_class begin = std::max(near, border);
    const Piece piece{to_number<Float>(begin), distant ? to_number<Float>(*distant) : Float(0), freshest_near,
                      rho};
    const Float faded = freshest_near ? Float(exp(-rho * (piece.near - freshest_at()))) : Float(1);
    sum += faded * far_piece(kernel, piece, !distant);
  }
  return sum;
}

}  // namespace

Float history(Remembered kernel, const mpq_class& from, const std::optional<mpq_class>& to,
              const mpq_class& rate, bool coarse) {
  Float sum = 0;
  const int parity = kernel == Remembered::I1 ? 1 : -1;
  if (from < 0) {
    const mpq_class end = to && *to < 0 ? *to : mpq_class(0);
    sum += parity * one_side(kernel, -end, mpq_class(-from), false, rate, coarse);
  }
  if (!to || *to > 0) {
    const mpq_class begin = from > 0 ? from : mpq_class(0);
    const Float faded = exp(-to_number<Float>(mpq_class(rate * (begin - from))));
    sum += faded * one_side(kernel, begin, to, true, rate, coarse);
  }
  return sum;
}

Long history_of_sign(const mpq_class& from, const std::optional<mpq_class>& to, const mpq_class& rate) {
  const Long rho = to_number<Long>(rate);
  Long sum = 0;
  if (from < 0) {
    const mpq_class length = (to && *to < 0 ? *to : mpq_class(0)) - from;
    sum -= faded_length<Long>(rho, to_number<Long>(length));
  }
  if (!to || *to > 0) {
    const mpq_class begin = from > 0 ? from : mpq_class(0);
    // At rate 0 beside an infinite length, which is the same wherever it begins.
    const Long endless = rho > 0 ? Long(1 / rho) : to_number<Long>(mpq_class(from - begin));
    const Long rest = to ? faded_length<Long>(rho, to_number<Long>(mpq_class(*to - begin))) : endless;
    sum += exp(-to_number<Long>(mpq_class(rate * (begin - from)))) * rest;
  }
  return sum;
}

}  // namespace nipref::verify::confirm
