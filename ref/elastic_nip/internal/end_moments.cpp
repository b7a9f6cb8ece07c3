#include <limits>
#include <utility>

#include <nipref/ref/elastic_nip/internal/end_moments.hpp>

namespace nipref::ref {
namespace {

Float zeta(unsigned long s) {
  Float result;
  mpfr_zeta_ui(raw(result), s, MPFR_RNDN);
  return result;
}

/// Re psi(3/2 + i epsilon) - psi(3) = Re [psi(3/2 + i epsilon) - psi(3/2)] + 1/2 - 2 ln 2, the bracket by its
/// Taylor series, with sum_n (n + 3/2)^{-s} = (2^s - 1) zeta(s) - 2^s.
Float digamma_difference(const Float& epsilon) {
  Float sum = Float(0.5) - 2 * log(Float(2));
  Float power = -1;
  for (long j = 1;; ++j) {
    power *= -epsilon * epsilon;
    if (abs(power) < std::numeric_limits<Float>::epsilon() / 64) return sum;
    const Float two = ldexp(Float(1), 2 * j + 1);
    sum += power * ((two - 1) * zeta(static_cast<unsigned long>(2 * j + 1)) - two);
  }
}

/// From moments of T_k times i^{-k} to those of U_k.
void take_to_second_kind(std::vector<Float>& moments) {
  for (std::size_t k = 1; k < moments.size(); ++k) {
    moments[k] = 2 * moments[k];
    if (k > 1) moments[k] -= moments[k - 2];
  }
}

}  // namespace

EndMoments::EndMoments(const Float& epsilon, int count) {
  const Float at_pole = pi() * epsilon;
  std::vector<Float>&m = plain_, &e = logarithmic_;
  m.push_back((Float(0.5) + 2 * epsilon * epsilon) * pi() / cosh(at_pole));
  e.push_back(m[0] * (log(Float(2)) + digamma_difference(epsilon)));
  m.push_back(2 * epsilon * m[0] / 3);
  e.push_back((2 * epsilon * e[0] - m[1]) / 3);
  for (long k = 1; k + 1 < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    m.push_back((4 * epsilon * m[at] - (k - 3) * m[at - 1]) / (k + 3));
    e.push_back((4 * epsilon * e[at] - (k - 3) * e[at - 1] + m[at - 1] - m[at + 1]) / (k + 3));
  }
  take_to_second_kind(m);
  take_to_second_kind(e);
  negative_.emplace_back(0);
  for (long k = 2; k < count; ++k) negative_.push_back(k % 2 == 0 ? plain(k - 2) : -plain(k - 2));
}

const Float& EndMoments::plain(long k) const {
  return k >= 0 ? plain_[static_cast<std::size_t>(k)] : negative_[static_cast<std::size_t>(-k - 1)];
}

}  // namespace nipref::ref
