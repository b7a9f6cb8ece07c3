#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/line_loads.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

/// Beyond those asked for: a system that needs more counts as singular.
constexpr int most_extra_digits = 400;

/// Values of a kernel at the odd multiples 1, 3 .. 4m - 1 of a/b, and a bound on the error of each.
struct KernelValues {
  std::vector<Float> values;
  Float error = 0;

  [[nodiscard]] const Float& at(int odd_multiple) const {
    return values[static_cast<std::size_t>(odd_multiple / 2)];
  }
};

/// A linear system whose coefficients are known to `error`.
struct System {
  Matrix matrix;
  Vector right;
  Float error;  ///< of each coefficient of the matrix; those of `right` are good to rounding
};

/// A solution and what it is from the truth, in each component.
struct Solved {
  Vector unknowns;
  Float error;
  Float condition;
};

/// What of a problem does not change with the working precision.
struct Problem {
  const data::ElasticNip& nip;
  int elements;
  double contact_length;
  std::optional<double> creep;

  [[nodiscard]] Float half_element() const { return Float(contact_length) / (4 * elements); }
  [[nodiscard]] Float spacing() const { return half_element() / (Float(nip.sheet_thickness) / 2); }
  [[nodiscard]] Float normal_compliance() const {
    const Float poisson = nip.material.poisson;
    return 2 * (1 - poisson) * (1 + poisson) / Float(nip.material.young);
  }
  /// theta2/N.
  [[nodiscard]] Float beta() const {
    const Float poisson = nip.material.poisson;
    return (1 - 2 * poisson) / (2 * (1 - poisson));
  }
};

template <class Kernel>
KernelValues evaluate(const Problem& problem, int digits, Kernel kernel) {
  KernelValues result;
  for (int q = 0; q < 2 * problem.elements; ++q) {
    const Float alpha = (2 * q + 1) * problem.spacing();
    const Enclosure value = kernel(to_exact(alpha), digits);
    result.values.push_back(to_float(value.value));
    // Sums and differences of two values and a constant of order 1 round a few times; the text of alpha is
    // off by a unit, which |alpha dI/dalpha| < 2 (1 + alpha) turns into less than this.
    const Float rounding =
        8 * (2 + abs(result.values.back()) + alpha) * std::numeric_limits<Float>::epsilon();
    result.error = std::max<Float>(result.error, to_float(value.error_bound) + rounding);
  }
  return result;
}

/// Unknowns: d0, then the normal loads times N/pi. Rows: the normal displacement at 2 i a, i = 0 .. m.
System frictionless_system(const Problem& problem, const KernelValues& I1_values) {
  const int m = problem.elements;
  System system{Matrix(m + 1, m + 1), Vector(m + 1), 2 * I1_values.error};
  for (int i = 0; i <= m; ++i) {
    const Float y = 2 * i * problem.half_element();
    system.right(i) = y * y / (2 * Float(problem.nip.roller_radius));
    system.matrix(i, 0) = 1;
    for (int k = 1; k <= m; ++k) {
      system.matrix(i, k) = -(I1_values.at(std::abs(2 * (i - k) + 1)) + I1_values.at(2 * (i + k) - 1));
    }
  }
  return system;
}

/// The same with the shear loads times N/pi as further unknowns and v = creep Y at i = 1 .. m as further
/// rows.
System gripped_system(const Problem& problem, int digits) {
  const int m = problem.elements;
  const KernelValues normal = evaluate(problem, digits, I1);
  KernelValues coupling = evaluate(problem, digits, I3);
  for (Float& value : coupling.values) value -= problem.beta() * pi() / 2;
  const KernelValues tangential =
      evaluate(problem, digits, [](const Exact& alpha, int wanted) { return I6(alpha, Exact(0.0), wanted); });
  const auto coupling_at = [&](int multiple) {
    return multiple > 0 ? coupling.at(multiple) : Float(-coupling.at(-multiple));
  };
  const System above = frictionless_system(problem, normal);
  System system{Matrix(2 * m + 1, 2 * m + 1), Vector(2 * m + 1),
                2 * std::max({normal.error, coupling.error, tangential.error})};
  system.matrix.set_block(0, 0, above.matrix);
  system.right.set_block(0, 0, above.right);
  for (int i = 0; i <= m; ++i) {
    for (int k = 1; k <= m; ++k) {
      const int near = 2 * (i - k) + 1, far = 2 * (i + k) - 1;
      system.matrix(i, m + k) = coupling_at(near) - coupling_at(far);
      if (i == 0) continue;
      system.matrix(m + i, k) = coupling_at(near) + coupling_at(far);
      system.matrix(m + i, m + k) = tangential.at(std::abs(near)) - tangential.at(far);
    }
    if (i > 0) system.right(m + i) = Float(*problem.creep) * 2 * i * problem.half_element();
  }
  return system;
}

/// NaN if one of them is: what is no number must not pass for a small one.
Float larger(const Float& a, const Float& b) { return a >= b || !(a == a) ? a : b; }

Float row_sum_norm(const Matrix& matrix) {
  Float largest = 0;
  for (Matrix::Index i = 0; i < matrix.rows(); ++i) {
    Float sum = 0;
    for (Matrix::Index j = 0; j < matrix.columns(); ++j) sum += abs(matrix(i, j));
    largest = larger(largest, sum);
  }
  return largest;
}

Float largest_of(const Vector& vector) {
  Float largest = 0;
  for (Matrix::Index i = 0; i < vector.size(); ++i) largest = larger(largest, abs(vector(i)));
  return largest;
}

/// Nothing if the precision does not suffice to prove a bound. Sums of n products are off by at most (n + 2)
/// units of the sum of their sizes.
std::optional<Solved> solve(const System& system) {
  const auto n = system.matrix.rows();
  const Matrix inverse = system.matrix.inverse();
  const Vector unknowns = inverse * system.right;
  const Float unit = (n + 2) * std::numeric_limits<Float>::epsilon();
  const Float size = row_sum_norm(system.matrix) + n * system.error;
  const Float inverse_size = row_sum_norm(inverse);
  const Matrix product = inverse * system.matrix;
  const Float defect = row_sum_norm(Matrix::identity(n) - product) + unit * inverse_size * size +
                       inverse_size * n * system.error;
  if (!(defect < 0.5)) return std::nullopt;
  const Vector residual = system.right - system.matrix * unknowns;
  const Float of_residual = unit * (size * largest_of(unknowns) + 4 * largest_of(system.right)) +
                            n * system.error * largest_of(unknowns);
  const Float error = inverse_size * (largest_of(residual) + of_residual) / (1 - defect);
  return Solved{unknowns, error, size * inverse_size};
}

Enclosure enclosed(const Float& value, const Float& error, int digits) {
  return {to_real(value), to_real(error * (1 + Float(1e-3))), digits};
}

LineLoadSolution solution_of(const Problem& problem, const Solved& solved, int digits) {
  const int m = problem.elements;
  const Float length = problem.contact_length;
  const Float unit = pi() / problem.normal_compliance();
  // What turns unknowns into results rounds a few times.
  const auto with_rounding = [&](const Float& value, const Float& error) {
    return enclosed(value, error + 20 * abs(value) * std::numeric_limits<Float>::epsilon(), digits);
  };
  const auto load_at = [&](int index) {
    return with_rounding(unit * solved.unknowns(index), unit * solved.error);
  };
  Float sum = 0;
  for (int k = 1; k <= m; ++k) sum += solved.unknowns(k);
  const Float d0 = solved.unknowns(0);
  const Float d1 = d0 - length * length / (8 * Float(problem.nip.roller_radius));
  LineLoadSolution solution{enclosed(d0, solved.error, digits),
                            with_rounding(d1, solved.error + abs(d0) * std::numeric_limits<Float>::epsilon()),
                            with_rounding(2 * unit * sum, 2 * m * unit * solved.error),
                            {},
                            {},
                            static_cast<double>(solved.condition)};
  for (int k = 1; k <= m; ++k) solution.line_loads.push_back(load_at(k));
  if (problem.creep) {
    for (int k = 1; k <= m; ++k) solution.shear_loads.push_back(load_at(m + k));
  }
  return solution;
}

/// Solves with more and more digits until the bound is 10^-digits of the largest unknown; nothing if
/// most_extra_digits do not prove that.
template <class Assemble>
std::optional<LineLoadSolution> solve_to(const Problem& problem, int digits, Assemble assemble) {
  for (int extra = 15; extra <= most_extra_digits; extra += extra + 10) {
    const WorkingDigits working(digits + extra);
    const auto solved = solve(assemble(digits + extra - 3));
    if (!solved) continue;
    if (solved->error <= pow(Float(10), -digits) * largest_of(solved->unknowns)) {
      return solution_of(problem, *solved, digits);
    }
  }
  return std::nullopt;
}

LineLoadSolution found(std::optional<LineLoadSolution> solution, double contact_length) {
  if (solution) return *std::move(solution);
  throw BadInput("contact_length", contact_length,
                 "must be one whose system is farther from singular than the reference can tell");
}

void check(const data::ElasticNip& nip, int elements, double contact_length, int digits) {
  nip.check();
  if (elements < 1 || elements > 200) {
    throw BadInput("elements_per_side", std::to_string(elements), "must be from 1 to 200 in the reference");
  }
  if (digits < 16 || digits > 300) throw BadInput("digits", std::to_string(digits), "must be from 16 to 300");
  const double half_element = contact_length / (4 * elements) / nip.half_thickness();
  // Farther loads than the reference kernels reach do not occur within 1000 half-thicknesses.
  if (!(contact_length > 0 && half_element * 4 * elements <= 1000)) {
    throw BadInput("contact_length", contact_length,
                   "must be > 0 and at most 500 sheet thicknesses in the reference");
  }
}

}  // namespace

LineLoadSolution line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                       double contact_length, int digits) {
  check(nip, elements_per_side, contact_length, digits);
  const Problem problem{nip, elements_per_side, contact_length, {}};
  return found(solve_to(problem, digits,
                        [&](int kernel_digits) {
                          return frictionless_system(problem, evaluate(problem, kernel_digits, I1));
                        }),
               contact_length);
}

LineLoadSolution gripped_line_loads_for_length(const data::ElasticNip& nip, int elements_per_side,
                                               double contact_length, double creep, int digits) {
  check(nip, elements_per_side, contact_length, digits);
  if (!std::isfinite(creep)) throw BadInput("creep", creep, "must be finite");
  const Problem problem{nip, elements_per_side, contact_length, creep};
  return found(
      solve_to(problem, digits, [&](int kernel_digits) { return gripped_system(problem, kernel_digits); }),
      contact_length);
}

LineLoadSolution line_loads_from_kernel_values(const data::ElasticNip& nip, std::span<const double> kernel,
                                               double contact_length, int digits) {
  const int elements = static_cast<int>(kernel.size() / 2);
  check(nip, elements, contact_length, digits);
  if (kernel.size() % 2 != 0) {
    throw BadInput("kernel", std::to_string(kernel.size()) + " values", "must have 2m values");
  }
  for (const double value : kernel) {
    if (!std::isfinite(value)) throw BadInput("kernel", value, "must be finite");
  }
  const Problem problem{nip, elements, contact_length, {}};
  auto solution = solve_to(problem, digits, [&](int) {
    return frictionless_system(problem, {std::vector<Float>(kernel.begin(), kernel.end()), 0});
  });
  if (!solution) {
    throw BadInput("kernel", kernel.front(),
                   "must be values that make no singular system (this is the first)");
  }
  return *std::move(solution);
}

}  // namespace nipref::ref
