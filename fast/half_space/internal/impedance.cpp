#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/fast/half_space/internal/impedance.hpp>

namespace nipref::fast::internal {
namespace {

double high_word(double x) { return x; }
double high_word(Two x) { return x.high; }

/// Inverts a matrix by Gauss-Jordan elimination with column pivoting. Returns the base-2 logarithm of |det|, or nothing
/// if the determinant is 0 or not a number.
template <class Number, std::size_t size>
std::optional<double> invert_in_place(Square<Number, size>& a) {
  std::array<std::size_t, size> swapped{};
  double log2_determinant = 0;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < size; ++i)
      if (std::fabs(high_word(a[i][k])) > std::fabs(high_word(a[pivot][k]))) pivot = i;
    swapped[k] = pivot;
    if (pivot != k) std::swap(a[pivot], a[k]);
    const double magnitude = std::fabs(high_word(a[k][k]));
    if (!(magnitude > 0) || !std::isfinite(magnitude)) return std::nullopt;
    log2_determinant += std::log2(magnitude);
    const Number reciprocal = Number{1} / a[k][k];
    a[k][k] = Number{1};
    for (Number& entry : a[k]) entry = entry * reciprocal;
    for (std::size_t i = 0; i < size; ++i) {
      if (i == k) continue;
      const Number factor = a[i][k];
      a[i][k] = Number{0};
      for (std::size_t j = 0; j < size; ++j) a[i][j] = a[i][j] - factor * a[k][j];
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    if (swapped[k] == k) continue;
    for (auto& row : a) std::swap(row[k], row[swapped[k]]);
  }
  return log2_determinant;
}

/// The matrix sign function, divided by i, of a real matrix without real eigenvalues. Returns nothing if Newton's
/// iteration does not converge.
template <class Number>
std::optional<Square<Number, 6>> sign_of(Square<Number, 6> x) {
  constexpr int most = 80;
  constexpr double converged =
      1e-17;  // the iteration is quadratic, and the square is below the rounding of two words
  for (int step = 0; step < most; ++step) {
    Square<Number, 6> inverse = x;
    const auto log2_determinant = invert_in_place(inverse);
    if (!log2_determinant) return std::nullopt;
    // Scaling by powers of two brings the moduli of the eigenvalues near 1 while they are far from 1.
    const double scale = std::exp2(-std::round(*log2_determinant / 6));
    double change = 0, size = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t k = 0; k < 6; ++k) {
        const Number next = (0.5 * scale) * x[i][k] - (0.5 / scale) * inverse[i][k];
        change = std::max(change, std::fabs(high_word(next - x[i][k])));
        size = std::max(size, std::fabs(high_word(next)));
        x[i][k] = next;
      }
    }
    if (!std::isfinite(size)) return std::nullopt;
    // In double, rounding keeps the change above 1e-17.
    if (change <= std::max(converged, 0x1p-42 * (sizeof(Number) == sizeof(double))) * size) return x;
  }
  return std::nullopt;
}

template <class Number>
Number number_of(Two x) {
  if constexpr (sizeof(Number) == sizeof(double)) {
    return x.high;
  } else {
    return x;
  }
}

template <class Number>
Square<Number, 3> product(const Square<Number, 3>& a, const Square<Number, 3>& b) {
  return matrix_of<Number>([&](std::size_t i, std::size_t k) {
    return a[i][0] * b[0][k] + a[i][1] * b[1][k] + a[i][2] * b[2][k];
  });
}

template <class Number>
std::optional<Impedance<Number>> by_sign_function(const StrohBlocks& blocks, Number X) {
  const auto of = [](const Square<Two, 3>& block) {
    return matrix_of<Number>([&](std::size_t i, std::size_t k) { return number_of<Number>(block[i][k]); });
  };
  Square<Number, 3> q = of(blocks.q);
  const Square<Number, 3> r = of(blocks.r), t = of(blocks.t_inverse);
  for (std::size_t i = 0; i < 3; ++i) q[i][i] = q[i][i] - X;
  const auto transposed = matrix_of<Number>([&](std::size_t i, std::size_t k) { return r[k][i]; });
  const Square<Number, 3> tr = product(t, transposed), rtr = product(r, tr);  // T^-1 R^T, R T^-1 R^T
  Square<Number, 6> n{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      n[i][k] = -tr[i][k];
      n[i][k + 3] = t[i][k];
      n[i + 3][k] = rtr[i][k] - q[i][k];
      n[i + 3][k + 3] = -tr[k][i];
    }
  }
  const auto sign = sign_of<Number>(n);
  if (!sign) return std::nullopt;
  const auto s = matrix_of<Number>([&](std::size_t i, std::size_t k) { return (*sign)[i][k]; });
  auto h = matrix_of<Number>([&](std::size_t i, std::size_t k) { return (*sign)[i][k + 3]; });
  if (!invert_in_place(h)) return std::nullopt;
  return Impedance<Number>{h, product(h, s)};
}

/// The independent entries of a Hermitian matrix: re where i <= k, then im where i < k.
constexpr std::size_t entries = 9, real_entries = 6;
constexpr std::array<std::array<std::size_t, 2>, entries> place_of_entry{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 1}, {0, 2}, {1, 2}}};

template <class Number>
void add_entry(Impedance<Number>& m, std::size_t entry, double change) {
  const auto [i, k] = place_of_entry[entry];
  auto& part = entry < real_entries ? m.re : m.im;
  part[i][k] = part[i][k] + Number{change};
  if (i != k) part[k][i] = entry < real_entries ? part[i][k] : -part[i][k];
}

/// The residual P^H T^-1 P - Q + X, P = M + i R^T, by its independent entries, and the matrix T^-1 P.
struct Residual {
  std::array<Two, entries> of_entry;
  Square<Two, 3> re, im;

  Residual(const Impedance<Two>& m, const StrohBlocks& blocks, Two X) {
    const auto im_of_p =
        matrix_of<Two>([&](std::size_t i, std::size_t k) { return m.im[i][k] + blocks.r[k][i]; });
    re = product(blocks.t_inverse, m.re);
    im = product(blocks.t_inverse, im_of_p);
    const auto dot = [](const Square<Two, 3>& a, std::size_t i, const Square<Two, 3>& b, std::size_t k) {
      return a[0][i] * b[0][k] + a[1][i] * b[1][k] + a[2][i] * b[2][k];
    };
    for (std::size_t entry = 0; entry < entries; ++entry) {
      const auto [i, k] = place_of_entry[entry];
      if (entry < real_entries)
        of_entry[entry] =
            dot(m.re, i, re, k) + dot(im_of_p, i, im, k) - blocks.q[i][k] + (i == k ? X : Two{0});
      else
        of_entry[entry] = dot(m.re, i, im, k) - dot(im_of_p, i, re, k);
    }
  }
};

/// The matrix of Lyapunov's equation D C + (D C)^H = -residual for the change D of M, where C = T^-1 P. Below the
/// limiting speed the eigenvalues -i p of C are to the right of the imaginary axis.
Eigen::Matrix<double, entries, entries> lyapunov_matrix(const Residual& at) {
  Eigen::Matrix<double, entries, entries> result;
  for (std::size_t unknown = 0; unknown < entries; ++unknown) {
    Impedance<double> unit{};
    add_entry(unit, unknown, 1);
    for (std::size_t entry = 0; entry < entries; ++entry) {
      const auto [i, k] = place_of_entry[entry];
      const auto of_product = [&](std::size_t row, std::size_t column) {
        double sum = 0;
        for (std::size_t j = 0; j < 3; ++j)
          sum += entry < real_entries
                     ? unit.re[row][j] * at.re[j][column].high - unit.im[row][j] * at.im[j][column].high
                     : unit.re[row][j] * at.im[j][column].high + unit.im[row][j] * at.re[j][column].high;
        return sum;
      };
      result(static_cast<Eigen::Index>(entry), static_cast<Eigen::Index>(unknown)) =
          entry < real_entries ? of_product(i, k) + of_product(k, i) : of_product(i, k) - of_product(k, i);
    }
  }
  return result;
}

/// Refines M by Newton's method with the derivative at the start, until the next change would be below the rounding
/// error. Returns nothing if the changes do not decrease fast.
std::optional<Impedance<Two>> refined(const Impedance<double>& start, const StrohBlocks& blocks, Two X) {
  constexpr int most = 5;
  constexpr double rounding = 0x1p-104, slowest_fall = 0x1p-12;
  Impedance<Two> m{};
  for (std::size_t entry = 0; entry < entries; ++entry) {
    const auto [i, k] = place_of_entry[entry];
    add_entry(m, entry, (entry < real_entries ? start.re : start.im)[i][k]);
  }
  Eigen::PartialPivLU<Eigen::Matrix<double, entries, entries>> derivative;
  double size = 0;
  for (const auto& row : start.re)
    for (const double entry : row) size = std::max(size, std::fabs(entry));
  double last = size;
  for (int step = 0; step < most; ++step) {
    const Residual residual(m, blocks, X);
    if (step == 0) derivative.compute(lyapunov_matrix(residual));
    Eigen::Vector<double, entries> right;
    for (std::size_t entry = 0; entry < entries; ++entry)
      right(static_cast<Eigen::Index>(entry)) = -residual.of_entry[entry].high;
    const Eigen::Vector<double, entries> change = derivative.solve(right);
    const double largest = change.cwiseAbs().maxCoeff();
    if (!(largest <= slowest_fall * last)) return std::nullopt;
    for (std::size_t entry = 0; entry < entries; ++entry)
      add_entry(m, entry, change(static_cast<Eigen::Index>(entry)));
    if (step > 0 && largest * (largest / last) <= rounding * size) return m;
    last = largest;
  }
  return std::nullopt;
}

}  // namespace

Square<Two, 3> inverse(Square<Two, 3> matrix) {
  invert_in_place(matrix);
  return matrix;
}

std::optional<Impedance<double>> impedance(const StrohBlocks& blocks, double X) {
  return by_sign_function(blocks, X);
}

std::optional<Impedance<Two>> impedance(const StrohBlocks& blocks, Two X) {
  if (const auto start = impedance(blocks, X.high)) {
    if (const auto m = refined(*start, blocks, X)) return m;
  }
  return by_sign_function(blocks, X);
}

}  // namespace nipref::fast::internal
