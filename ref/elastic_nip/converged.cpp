#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/elastic_nip/converged.hpp>
#include <nipref/ref/number/internal/linear_algebra.hpp>
#include <nipref/ref/sheet/kernels.hpp>

namespace nipref::ref {
namespace {

using data::BadInput;

constexpr int guard_digits = 15;
constexpr int most_digits = 100;
constexpr int most_terms = 900;
constexpr int most_steps = 30;  ///< of the search for a load

/// One solved expansion, dimensionless: lengths in half-thicknesses b, normal displacements times 2 R/b^2,
/// pressures times 2 R N/b.
struct Expansion {
  Float half_length;
  Vector coefficients;
  Float edge_displacement;

  [[nodiscard]] Float load() const { return half_length * pi() / 2 * coefficients(0); }
  [[nodiscard]] Float indentation() const { return edge_displacement + half_length * half_length; }
  /// y in half-thicknesses.
  [[nodiscard]] Float pressure(const Float& y) const {
    if (abs(y) >= half_length) return 0;
    const Float angle = acos(y / half_length);
    Float sum = 0;
    for (Matrix::Index k = 0; k < coefficients.size(); ++k) sum += coefficients(k) * sin((2 * k + 1) * angle);
    return sum;
  }
};

/// I1(a) + ln a for a != 0.
Float smooth_kernel(const Float& alpha, int digits) {
  const Float size = abs(alpha);
  return to_float(I1(to_exact(size), digits).value) + log(size);
}

/// int -ln|t - s| sqrt(1 - s^2) U_n(s) ds at t = cos(angle), n even.
Float logarithm_of(int n, const Float& angle) {
  const Float lower = n == 0 ? Float(log(Float(2))) : Float(cos(n * angle) / n);
  return pi() / 2 * (lower - cos((n + 2) * angle) / (n + 2));
}

/// Matching points at odd, quadrature nodes at even multiples of pi/(4 (terms + 1)): they never meet.
Expansion expand(const Float& half_length, int terms, int digits, long& kernel_values) {
  const int size = terms + 1;
  const Float step = pi() / (4 * size);
  const auto odd = [&](int i) { return Float((2 * i + 1) * step); };
  Matrix nodes(size, terms);
  Vector positions(size);
  for (int j = 0; j < size; ++j) {
    const Float angle = 2 * (j + 1) * step;
    positions(j) = j == terms ? Float(0) : Float(cos(angle));
    // Gauss-Chebyshev weight times sqrt(1 - s^2) U_2k, half for each of the node and its mirror image.
    const Float weight = (j == terms ? 1 : 2) * step * sin(angle);
    for (int k = 0; k < terms; ++k) nodes(j, k) = weight * sin((2 * k + 1) * angle);
  }
  Matrix matrix(size, size);
  Vector gap(size);
  Matrix smooth(size, size);
  for (int i = 0; i < size; ++i) {
    const Float t = cos(odd(i));
    for (int j = 0; j < size; ++j) {
      smooth(i, j) = smooth_kernel(half_length * (t - positions(j)), digits) +
                     smooth_kernel(half_length * (t + positions(j)), digits);
    }
  }
  kernel_values += 2L * size * size;
  const Float factor = half_length / pi();
  matrix.set_block(0, 0, smooth * nodes);
  for (int i = 0; i < size; ++i) {
    for (int k = 0; k < terms; ++k) matrix(i, k) += logarithm_of(2 * k, odd(i));
    matrix(i, 0) -= pi() / 2 * log(half_length);
    for (int k = 0; k < terms; ++k) matrix(i, k) *= factor;
    matrix(i, terms) = -1;
    const Float height = half_length * sin(odd(i));
    gap(i) = height * height;
  }
  const Vector unknowns = solve(matrix, gap);
  return {half_length, unknowns.block(0, 0, terms, 1), unknowns(terms)};
}

int terms_of_level(double half_length, int level) {
  return static_cast<int>(std::ceil((4 + 2 * half_length) * std::pow(1.5, level)));
}

/// Of the last level.
int most_terms_for(double half_length) {
  int level = 0;
  while (terms_of_level(half_length, level + 1) <= most_terms) ++level;
  return terms_of_level(half_length, level);
}

void check_digits_here(int digits) {
  if (digits < 16 || digits > most_digits)
    throw BadInput("digits", std::to_string(digits), "must be from 16 to 100");
}

/// In sheet thicknesses.
constexpr double shortest = 1e-6, longest = 20;

constexpr auto allowed_lengths =
    "must be at most the roller's radius and from 1e-6 to 20 sheet thicknesses for the reference expansion";

bool length_is_allowed(const data::ElasticNip& nip, double length) {
  return length >= shortest * nip.sheet_thickness && length <= longest * nip.sheet_thickness &&
         length <= nip.roller_radius;
}

/// A guess at the half length that carries a load, between that of a half-space and that of springs.
double first_length(double load) {
  double length = std::sqrt(load / 3.14159);
  for (int i = 0; i < 5; ++i) length = std::sqrt(load / (3.14159 + 8 * length / 3));
  return length > shortest ? std::min(length, longest) : shortest;
}

}  // namespace

struct ConvergedElasticNip::Implementation {
  data::ElasticNip nip;
  int digits;
  long kernel_values = 0;
  std::array<Expansion, 3> expansions{};

  [[nodiscard]] Float half_thickness() const { return Float(nip.sheet_thickness) / 2; }
  /// b/(2R), unit of slopes.
  [[nodiscard]] Float slope() const { return half_thickness() / (2 * Float(nip.roller_radius)); }
  [[nodiscard]] Float pressure_unit() const {
    const Float poisson = nip.material.poisson;
    return slope() * Float(nip.material.young) / (2 * (1 - poisson) * (1 + poisson));
  }

  /// `next` gives the expansion of a number of terms, starting from the last half length. BadInput "digits"
  /// if the terms that are tried do not give them.
  void climb(const std::function<Expansion(const Float& near, int terms)>& next, Float near) {
    double digits_before = 0;
    int terms_before = 0;
    for (int level = 0;; ++level) {
      const int terms = terms_of_level(static_cast<double>(near), level);
      std::ranges::rotate(expansions, expansions.begin() + 1);
      expansions[2] = next(near, terms);
      near = expansions[2].half_length;
      if (level < 2) continue;
      const double reached = -std::log10(static_cast<double>(largest_relative_error()));
      if (reached >= digits) return;
      const int most = most_terms_for(static_cast<double>(near));
      // Digits grow with the terms. The first levels may see too little of a long contact to tell.
      const double in_sight =
          reached + (reached - digits_before) / (terms - terms_before) * std::max(0, most - terms);
      if (terms >= most || (level >= 4 && in_sight < 0.95 * digits)) refuse_digits(in_sight, most);
      digits_before = reached;
      terms_before = terms;
    }
  }

  [[nodiscard]] Float largest_relative_error() const {
    Float largest = 0;
    for (const std::function<Float(const Expansion&)>& result :
         {std::function<Float(const Expansion&)>(&Expansion::load),
          {&Expansion::indentation},
          {[](const Expansion& e) { return e.pressure(0); }},
          {&Expansion::half_length}}) {
      const Estimated estimate = estimate_of(result, 1);
      const Float relative = to_float(estimate.error) / abs(to_float(estimate.value));
      if (!(relative < 1)) return 1;
      largest = std::max<Float>(largest, relative);
    }
    return largest;
  }

  [[noreturn]] void refuse_digits(double in_sight, int most) const {
    throw BadInput(
        "digits", std::to_string(digits),
        fmt::format("must be fewer for a contact of {:.6g} sheet thicknesses: with {} terms, the most "
                    "that are tried, its expansion is good to about {:.0f}",
                    static_cast<double>(expansions[2].half_length), most, in_sight));
  }

  [[nodiscard]] Estimated estimate_of(const std::function<Float(const Expansion&)>& result,
                                      const Float& unit) const {
    const WorkingDigits working(digits + guard_digits);
    const Float before = abs(result(expansions[1]) - result(expansions[0]));
    const Float last = result(expansions[2]);
    const Float change = abs(last - result(expansions[1]));
    const Float rate = change < before ? Float(change / before) : Float(1);
    const Float rounding = pow(Float(10), -digits - guard_digits / 3) * abs(last);
    const Float error = 10 * change * rate;
    return {to_real(unit * last), to_real(abs(unit) * (error > rounding ? error : rounding)), digits};
  }
};

ConvergedElasticNip::ConvergedElasticNip(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ConvergedElasticNip::ConvergedElasticNip(ConvergedElasticNip&&) noexcept = default;
ConvergedElasticNip::~ConvergedElasticNip() = default;

Estimated ConvergedElasticNip::contact_length() const {
  const WorkingDigits working(implementation_->digits + guard_digits);
  return implementation_->estimate_of([](const Expansion& e) { return e.half_length; },
                                      2 * implementation_->half_thickness());
}

Estimated ConvergedElasticNip::load() const {
  const WorkingDigits working(implementation_->digits + guard_digits);
  return implementation_->estimate_of([](const Expansion& e) { return e.load(); },
                                      implementation_->pressure_unit() * implementation_->half_thickness());
}

Estimated ConvergedElasticNip::indentation() const {
  const WorkingDigits working(implementation_->digits + guard_digits);
  return implementation_->estimate_of([](const Expansion& e) { return e.indentation(); },
                                      implementation_->slope() * implementation_->half_thickness());
}

Estimated ConvergedElasticNip::edge_displacement() const {
  const WorkingDigits working(implementation_->digits + guard_digits);
  return implementation_->estimate_of([](const Expansion& e) { return e.edge_displacement; },
                                      implementation_->slope() * implementation_->half_thickness());
}

Estimated ConvergedElasticNip::pressure(double y) const {
  if (!std::isfinite(y)) throw BadInput("y", y, "must be finite");
  const WorkingDigits working(implementation_->digits + guard_digits);
  const Float position = Float(y) / implementation_->half_thickness();
  return implementation_->estimate_of([&](const Expansion& e) { return e.pressure(position); },
                                      implementation_->pressure_unit());
}

int ConvergedElasticNip::terms() const {
  return static_cast<int>(implementation_->expansions[2].coefficients.size());
}
long ConvergedElasticNip::kernel_values() const { return implementation_->kernel_values; }

ConvergedElasticNip converged_for_length(const data::ElasticNip& nip, double contact_length, int digits) {
  nip.check();
  check_digits_here(digits);
  if (!length_is_allowed(nip, contact_length))
    throw BadInput("contact_length", contact_length, allowed_lengths);
  const WorkingDigits working(digits + guard_digits);
  auto solved = std::make_unique<ConvergedElasticNip::Implementation>(nip, digits);
  solved->climb([&](const Float& near,
                    int terms) { return expand(near, terms, digits + guard_digits, solved->kernel_values); },
                Float(contact_length) / Float(nip.sheet_thickness));
  return ConvergedElasticNip(std::move(solved));
}

ConvergedElasticNip converged_for_load(const data::ElasticNip& nip, double load, int digits) {
  nip.check();
  check_digits_here(digits);
  if (!(std::isfinite(load) && load > 0)) throw BadInput("load", load, "must be finite and > 0");
  const WorkingDigits working(digits + guard_digits);
  auto solved = std::make_unique<ConvergedElasticNip::Implementation>(nip, digits);
  const Float wanted = Float(load) / (solved->pressure_unit() * solved->half_thickness());
  const Float enough = pow(Float(10), -digits - guard_digits / 2);
  // Secant iteration on ln(load) of ln(length); the slope lies between 2 (half-space) and 3 (springs).
  const auto solve = [&](const Float& near, int terms) {
    Float log_length = log(near), last_log_length = 0, last_excess = 0, slope = 2.5;
    for (int step = 0; step < most_steps; ++step) {
      Expansion expansion = expand(exp(log_length), terms, digits + guard_digits, solved->kernel_values);
      const Float excess = log(expansion.load() / wanted);
      if (abs(excess) <= enough) return expansion;
      if (step > 0) slope = (excess - last_excess) / (log_length - last_log_length);
      last_log_length = std::exchange(log_length, log_length - excess / slope);
      last_excess = excess;
      if (!length_is_allowed(nip, static_cast<double>(exp(log_length)) * nip.sheet_thickness)) {
        throw BadInput("load", load, std::string("gives a contact whose length ") + allowed_lengths);
      }
    }
    throw BadInput(
        "load", load,
        fmt::format("gives a contact whose length is not found to {} digits in {} steps: fewer digits "
                    "must be asked for",
                    digits, most_steps));
  };
  solved->climb(solve, Float(first_length(static_cast<double>(wanted))));
  return ConvergedElasticNip(std::move(solved));
}

}  // namespace nipref::ref
