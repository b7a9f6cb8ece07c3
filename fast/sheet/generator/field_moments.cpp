#include <array>

#include <nipref/fast/sheet/generator/component_series.hpp>
#include <nipref/fast/sheet/generator/tabulate.hpp>

namespace nipref::fast::generator {
namespace {

using internal::FieldFunction;

constexpr int moment_count = internal::near_load_terms;

int index(FieldFunction function) { return static_cast<int>(function); }

/// Coefficients m_k of I7's rest sum m_k w^2k and n_k of I5's rest w sum n_k w^2k, one more of each than the table has.
struct Moments {
  std::array<Real, moment_count + 1> m{}, n{};
};

/// Computes the moments by the trapezoidal rule. Its error is e^{-2 pi Im(z_1)/step} = 1e-91, since z^2k sinh z/S and
/// z^(2k+1) cosh z/S are even and analytic up to the first root. The moments of 2 e^{-z} are 2.
Moments moments() {
  constexpr int steps_in_unit = 16, end = 420;
  Moments sums;
  sums.m[0] = Real(1) / 4;
  sums.n[0] = Real(1) / 4;
  for (int j = 1; j <= steps_in_unit * end; ++j) {
    const Real z = Real(j) / steps_in_unit, S = sinh(2 * z) + 2 * z;
    const Real even = 2 * sinh(z) / S, odd = 2 * cosh(z) / S;
    Real power = 1;  // z^2k/(2k)!
    for (int k = 0; k <= moment_count; ++k) {
      sums.m[static_cast<std::size_t>(k)] += even * power;
      power *= z / (2 * k + 1);
      sums.n[static_cast<std::size_t>(k)] += odd * power;
      power *= z / (2 * k + 2);
    }
  }
  for (std::size_t k = 0; k < sums.m.size(); ++k) {
    const int sign = k % 2 == 0 ? 1 : -1;
    sums.m[k] = sign * (sums.m[k] / steps_in_unit - 2);
    sums.n[k] = sign * (sums.n[k] / steps_in_unit - 2);
  }
  return sums;
}

void fill_rest(const Real& K5_at_zero, internal::FieldTable& table) {
  const Moments series = moments();
  const auto set = [&](FieldFunction function, int k, const Real& value) {
    table.rest[index(function)][k] = value.convert_to<double>();
  };
  set(FieldFunction::K5, 0, K5_at_zero);
  for (int k = 0; k < moment_count; ++k) {
    const Real &m = series.m[static_cast<std::size_t>(k)], &n = series.n[static_cast<std::size_t>(k)];
    set(FieldFunction::I4, k, m / (2 * k + 1));
    set(FieldFunction::I7, k, m);
    set(FieldFunction::I7_slope, k, (2 * k + 2) * series.m[static_cast<std::size_t>(k) + 1]);
    set(FieldFunction::I5, k, n);
    set(FieldFunction::I5_slope, k, (2 * k + 1) * n);
    if (k + 1 < moment_count) set(FieldFunction::K5, k + 1, n / (2 * k + 2));
  }
}

void fill_residues(internal::FieldTable& table) {
  for (std::size_t r = 0; r < internal::field_roots; ++r) {
    const Complex& z = roots()[r];
    const Complex iz(-z.imag(), z.real()), cosh_z = cosh(z);
    const Complex I4 = -pi() / (cosh_z * cosh_z * cosh_z), I5 = pi() / cosh_z;
    // The order is that of FieldFunction.
    const std::array<Complex, internal::field_functions> amplitudes{
        I4, Complex(I5 / iz), I5, Complex(iz * I4), Complex(iz * I5), Complex(iz * iz * I4)};
    for (std::size_t f = 0; f < amplitudes.size(); ++f) {
      table.amplitude[r][f][0] = amplitudes[f].real().convert_to<double>();
      table.amplitude[r][f][1] = amplitudes[f].imag().convert_to<double>();
    }
  }
}

}  // namespace

std::unique_ptr<internal::FieldTable> tabulate_field() {
  auto table = std::make_unique<internal::FieldTable>();
  fill_rest(-ComponentSeries(internal::Component::eta_part_of_I6).about_zero().front(), *table);
  fill_residues(*table);
  return table;
}

}  // namespace nipref::fast::generator
