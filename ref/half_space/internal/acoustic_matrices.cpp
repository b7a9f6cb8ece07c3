#include <vector>

#include <nipref/ref/half_space/internal/acoustic_matrices.hpp>

namespace nipref::ref {
namespace {

/// Voigt's index of a pair of axes.
constexpr std::size_t voigt_index[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/// C_ijkl/C33 in intervals.
class Moduli {
 public:
  Moduli(const ExactStiffness& solid, mpfr_prec_t precision) {
    for (const auto& row : solid.voigt) {
      for (const auto& modulus : row) {
        values_.emplace_back(Exact(mpq_class(modulus / solid.voigt[2][2])), precision);
      }
    }
  }
  [[nodiscard]] const Interval& operator()(std::size_t i, std::size_t j, std::size_t k, std::size_t l) const {
    return values_[6 * voigt_index[i][j] + voigt_index[k][l]];
  }

 private:
  std::vector<Interval> values_;
};

}  // namespace

AcousticMatrices acoustic_matrices(const ExactStiffness& solid, const SurfaceDirection& psi,
                                   const Interval& inertia) {
  const mpfr_prec_t precision = inertia.precision();
  const Moduli c(solid, precision);
  const auto [n0, n1] = psi.at(precision);
  const auto q = [&](std::size_t i, std::size_t k) {
    const Interval static_part =
        square(n0) * c(i, 0, k, 0) + square(n1) * c(i, 1, k, 1) + n0 * n1 * (c(i, 0, k, 1) + c(i, 1, k, 0));
    return i == k ? static_part - inertia : static_part;
  };
  const auto r = [&](std::size_t i, std::size_t k) { return n0 * c(i, 0, k, 2) + n1 * c(i, 1, k, 2); };
  const auto t = [&](std::size_t i, std::size_t k) { return c(i, 2, k, 2); };
  return {IntervalMatrix::real(q), IntervalMatrix::real(r), IntervalMatrix::real(t)};
}

Interval inertia_of(const ExactStiffness& solid, const Exact& speed, const Interval& cosine) {
  const mpq_class factor = solid.density * speed.value() * speed.value() / solid.voigt[2][2];
  return Interval(factor, cosine.precision()) * square(cosine);
}

}  // namespace nipref::ref
