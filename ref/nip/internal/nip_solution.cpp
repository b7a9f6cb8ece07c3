#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/length_search.hpp>
#include <nipref/ref/nip/internal/nip_solution.hpp>

namespace nipref::ref {

using Index = Matrix::Index;

namespace {

/// Logarithm of the factor, about 5.8 = 3 + sqrt 8, by which Chebyshev's coefficients on a panel fall with each degree:
/// the panel is as far from the end, where the tractions are singular, as it is wide.
constexpr double nats_of_term = 1.76;
constexpr int fewest_terms = 8, most_terms = 1000000;

/// The degree from which on the coefficients of e^(-rate e) on a panel are below e^-nats. On the ellipse whose
/// semi-axes sum to r half widths, the exponential is at most e^(size - fallen). The coefficient of degree n is at most
/// twice that over r^n. (Trefethen, Approximation Theory and Approximation Practice, 8.1)
int degree_of_exponential(const std::complex<double>& rate, double left, double width, double nats) {
  double best = most_terms;
  const double half = width / 2, fallen = rate.real() * (left + half);
  for (double r = 1.05; r < 1e4; r *= 1.1) {
    const double size = half * (rate.real() * (r + 1 / r) + std::fabs(rate.imag()) * (r - 1 / r)) / 2;
    best = std::min(best, std::max(0.0, (nats + size - fallen) / std::log(r)));
  }
  return static_cast<int>(std::ceil(best));
}

int terms_of(double left, double width, const Resolution& resolution, double nats) {
  int degree = static_cast<int>(std::ceil(std::max(0.0, nats - resolution.decay * left) / nats_of_term));
  if (left > 0) {
    degree = std::max(degree, degree_of_exponential(resolution.decay, left, width, nats));
    for (const std::complex<double>& rate : resolution.rates)
      degree = std::max(degree, degree_of_exponential(rate, left, width, nats));
  }
  return std::max(fewest_terms, degree + 3);
}

}  // namespace

std::vector<TractionPanel> panels_of(const Float& half_length, const Resolution& resolution,
                                     const Fineness& fineness) {
  const auto size = static_cast<double>(half_length);
  std::vector<double> edges{0, fineness.first * resolution.first};
  while (edges.back() < size) edges.push_back(fineness.growth * edges.back());
  std::vector<TractionPanel> panels;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double left = edges[i] * size / edges.back(), right = edges[i + 1] * size / edges.back();
    panels.push_back({left, Float(right) - left, terms_of(left, right - left, resolution, fineness.nats)});
  }
  panels.back().width = half_length - panels.back().left;
  return panels;
}

namespace {
std::atomic<long> solutions = 0;
}

NipSolution::NipSolution(Tractions tractions, SheetKernels& kernels)
    : tractions_(std::move(tractions)), kernels_(kernels) {
  ++solutions;
}

long NipSolution::solved() { return solutions; }

PressureAndShear NipSolution::tractions(const Float& x) const {
  const Float left = 2 * half_length() - x;
  return x > 0 && left > 0 ? tractions(x, left) : PressureAndShear{0, 0};
}

PressureAndShear NipSolution::tractions(const Float& from_leading, const Float& from_trailing) const {
  if (from_leading <= from_trailing) return tractions_.at(from_leading, leading_);
  const PressureAndShear mirrored = tractions_.at(from_trailing, trailing_);
  return {mirrored.pressure, -mirrored.shear};
}

Float NipSolution::on_roller(const Float& x) const {
  return edge_displacement_ + x * (2 * half_length() - x) + 2 * offset_ * x;
}

std::vector<Float> NipSolution::signature() const {
  const Float &size = half_length(), pressure = load_ / size;
  std::vector<Float> numbers{log(load_), log(size), edge_displacement_ / (size * size), offset_ / size};
  constexpr int samples = 14;
  for (int i = 1; i < samples; ++i) {
    const PressureAndShear here = tractions((1 - cos(i * pi() / samples)) * size);
    numbers.push_back(here.pressure / pressure);
    numbers.push_back(here.shear / pressure);
  }
  return numbers;
}

namespace {

/// The decay rate of the slowest wave between the faces. Without friction it is pi: sinh^2 x has the zero i pi. With
/// full friction it is half the zero of (3 - 4 poisson) sin x = x, where 3 - 4 poisson = (1 + beta)/(1 - beta).
double decay_of(bool sticks, double beta) {
  if (!sticks) return std::numbers::pi;
  double low = 0, high = std::numbers::pi;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    ((1 + beta) / (1 - beta) * std::sin(middle) > middle ? low : high) = middle;
  }
  return low / 2;
}

}  // namespace

Float ElasticSheet::epsilon() const { return sticks_ ? Float(atanh(beta_) / pi()) : Float(0); }

Resolution ElasticSheet::resolution() const { return {decay_of(sticks_, static_cast<double>(beta_)), {}, 1}; }

namespace {

/// Displacements are matched at collocation points. With full friction v = creep y in the contact.
class ElasticSolution : public NipSolution {
 public:
  ElasticSolution(const ElasticSheet& sheet, Tractions tractions, SheetKernels& kernels)
      : NipSolution(std::move(tractions), kernels), sheet_(sheet) {
    const std::vector<Float> points = tractions_.matching_points();
    const auto count = static_cast<Index>(points.size());
    const Index columns = tractions_.columns();
    std::vector<LineFunctional> functionals{normal()};
    if (sheet_.sticks()) functionals.push_back(tangential());
    const Index size = columns + static_cast<Index>(functionals.size());
    Matrix matrix(size, size);
    Vector right(size);
    for (Index i = 0; i < count; ++i) {
      const Float& e = points[static_cast<std::size_t>(i)];
      const std::vector<Vector> rows = tractions_.rows(e, functionals, kernels_);
      matrix.row(i).leftCols(columns) = rows[0].transpose();
      if (sheet_.sticks()) matrix.row(count + i).leftCols(columns) = rows[1].transpose();
      // This unknown is the displacement at the end over A, so that all unknowns are of about one size.
      matrix(i, columns) = -half_length();
      right(i) = e * (2 * half_length() - e);
      if (sheet_.sticks()) matrix(count + i, columns + 1) = -(half_length() - e);
    }
    const Vector solution = refined_solution(matrix, right);
    leading_ = trailing_ = solution.block(0, 0, columns, 1);
    edge_displacement_ = solution(columns) * half_length();
    if (sheet_.sticks()) creep_ = solution(columns + 1);
    load_ = 2 * tractions_.integral().cwiseProduct(leading_).sum();
  }

  [[nodiscard]] Float growth() const override {
    const auto [a, b] = tractions_.at_root(leading_);
    const Float epsilon = sheet_.epsilon(), cosine = cosh(pi() * epsilon);
    return pi() * half_length() * (a * a + b * b) * (1 + 4 * epsilon * epsilon) /
           (4 * panels().front().width * load_ * cosine * cosine);
  }

  [[nodiscard]] Float normal(const Float& x) const override {
    return before_end(x) < 0 ? value(x, normal()) : on_roller(x);
  }

  [[nodiscard]] Float tangential(const Float& x) const override {
    if (sheet_.sticks() && before_end(x) >= 0) return creep_ * (half_length() - x);
    const Float along = value(x, tangential());
    return x <= half_length() ? along : Float(-along);
  }

  [[nodiscard]] Float strain(const Float& x) const override {
    if (sheet_.sticks() && before_end(x) >= 0) return creep_;
    LineFunctional slope;
    slope.pressure(Influence::coupling_slope, 1 / pi());
    if (sheet_.sticks()) slope.shear(Influence::normal_slope, 1 / pi()).shear(Influence::coupling, -1 / pi());
    return value(x, slope) - sheet_.beta() * tractions(x).pressure;
  }

 private:
  [[nodiscard]] LineFunctional normal() const {
    LineFunctional result;
    result.pressure(Influence::normal, 1 / pi());
    if (sheet_.sticks())
      result.shear(Influence::sign, sheet_.beta() / 2).shear(Influence::coupling, -1 / pi());
    return result;
  }

  [[nodiscard]] LineFunctional tangential() const {
    LineFunctional result;
    result.pressure(Influence::sign, -sheet_.beta() / 2).pressure(Influence::coupling, 1 / pi());
    if (sheet_.sticks()) result.shear(Influence::normal, 1 / pi()).shear(Influence::stretch, 1 / pi());
    return result;
  }

  /// The distance from the nearer end, negative outside the contact.
  [[nodiscard]] Float before_end(const Float& x) const {
    return x <= half_length() ? x : Float(2 * half_length() - x);
  }

  [[nodiscard]] Float value(const Float& x, const LineFunctional& functional) const {
    return tractions_.rows(before_end(x), {functional}, kernels_).front().cwiseProduct(leading_).sum();
  }

  const ElasticSheet& sheet_;
  Float creep_;
};

}  // namespace

std::unique_ptr<NipSolution> ElasticSheet::solved(const Float& half_length, std::vector<TractionPanel> panels,
                                                  double nats, SheetKernels& kernels) const {
  return std::make_unique<ElasticSolution>(
      *this, Tractions(half_length, std::move(panels), epsilon(), sticks_, nats), kernels);
}

namespace {

constexpr int most_unknowns = 1400;
/// Digits of kernels and integrals beyond those of the results in the finer solution, and how many fewer the coarser
/// one has. A node of a kernel's interpolation is worth 1.45 digits, one of an integral's rule 1.09. So the errors of
/// the coarser solution's are larger, and the difference of both solutions contains what they do to a result, however
/// much the contact amplifies it: ref/README.md, Lemma 14.
constexpr int kernel_guard = 8, quadrature_guard = 6, fewer_of_kernels = 2, fewer_of_quadrature = 1;
constexpr int search_digits = 10;

double first_nats(int digits) { return digits * std::numbers::ln10 + 2; }

/// With a growth of 2.2 coefficients fall by 5.14 with each degree, not by the 5.83 of nats_of_term: the finer solution
/// has 1.11 nats, at 16 digits an eightieth of the coarser one's truncation error. Twice the difference is enough if it
/// is two thirds: ref/README.md, Lemma 14.
Fineness fineness_of(bool fine, double nats) {
  return fine ? Fineness{1.5, 2.2, 1.2 * nats} : Fineness{1.3, 2, nats};
}

/// The number of unknowns of a contact on these panels; BadInput if it is above the limit.
int checked_unknowns(const NipSheet& sheet, const std::vector<TractionPanel>& panels, int digits) {
  int terms = 0;
  for (const TractionPanel& panel : panels) terms += panel.terms;
  const int unknowns = sheet.unknowns(terms);
  if (unknowns > most_unknowns)
    throw data::BadInput("digits", std::to_string(digits),
                         "must be fewer, or the contact shorter: the reference tries " +
                             std::to_string(most_unknowns) + " unknowns at most, and this takes " +
                             std::to_string(unknowns));
  return unknowns;
}

}  // namespace

SolvedNip::SolvedNip(Sheet sheet, int digits)
    : sheet_(std::move(sheet)),
      digits_(digits),
      kernels_(std::make_unique<SheetKernels>(digits + kernel_guard)),
      coarse_kernels_(std::make_unique<SheetKernels>(digits + kernel_guard - fewer_of_kernels)) {}

SolvedNip SolvedNip::of_half_length(const Sheet& sheet, const Float& half_length, int digits) {
  SolvedNip nip(sheet, digits);
  nip.solve([&](bool fine, double nats) { return nip.solution(half_length, fine, nats); });
  return nip;
}

SolvedNip SolvedNip::of_load(const Sheet& sheet, const Float& load, double guess, int digits,
                             const Check& check) {
  LengthSearch search{.load = to_exact(load), .length = guess, .longest_step = 1};
  {  // First, a search with few digits.
    const WorkingDigits working(working_digits(search_digits, sheet->lost_digits()));
    const SolvedNip few(sheet, search_digits);
    search.seek(search_digits, [&](const Lengths& at) {
      check(static_cast<double>(at.length));
      first_unknowns(*sheet, at.length, digits);
      return few.solution(at.length, false, first_nats(search_digits));
    });
  }
  check(static_cast<double>(search.length));
  search.length = at_working_precision(search.length);
  SolvedNip nip(sheet, digits);
  // W rises at most like A^5, in a thin incompressible sheet with full friction, and the other results more slowly. So
  // this error of the length changes them by less than `least` in estimate().
  const Float enough = pow(Float(10), -digits) / 1000;
  const auto solve_at = [&](bool fine, double nats) {
    std::unique_ptr<NipSolution> here;
    search.seek(digits + 3, [&](const Lengths& at) {
      here = nip.solution(at.length, fine, nats);
      return here.get();
    });
    const bool is_there = abs(search.length - here->half_length()) <= enough * search.length;
    return is_there ? std::move(here) : nip.solution(search.length, fine, nats);
  };
  nip.solve(solve_at);
  return nip;
}

int SolvedNip::first_unknowns(const NipSheet& sheet, const Float& half_length, int digits) {
  const auto panels = panels_of(half_length, sheet.resolution(), fineness_of(true, first_nats(digits)));
  return checked_unknowns(sheet, panels, digits);
}

int SolvedNip::unknowns() const { return checked_unknowns(*sheet_, fine_->panels(), digits_); }

KernelValues SolvedNip::kernel_values() const { return kernels_->values() + coarse_kernels_->values(); }

Float SolvedNip::kernel_share() { return pow(Float(10), 2 - kernel_guard); }

data::WithError<Float> SolvedNip::estimate(const Functional& functional, const Float& scale) const {
  Float value = functional(*fine_);
  const Float least = pow(Float(10), -digits_) / 100;
  Float error =
      2 * abs(value - functional(*coarse_)) + (difference_ + least) * std::max(scale, Float(abs(value)));
  return {std::move(value), std::move(error)};
}

std::unique_ptr<NipSolution> SolvedNip::solution(const Float& half_length, bool fine, double nats) const {
  auto panels = panels_of(half_length, sheet_->resolution(), fineness_of(fine, nats));
  checked_unknowns(*sheet_, panels, digits_);
  const int of_quadrature = digits_ + quadrature_guard - (fine ? 0 : fewer_of_quadrature);
  return sheet_->solved(half_length, std::move(panels), of_quadrature * std::numbers::ln10,
                        fine ? *kernels_ : *coarse_kernels_);
}

void SolvedNip::solve(const std::function<std::unique_ptr<NipSolution>(bool, double)>& solve_at) {
  // Three times the largest difference, and `least`, are then below 10^-digits of the scale in estimate().
  const Float enough = pow(Float(10), -digits_) / 4;
  for (double nats = first_nats(digits_);; nats *= 1.25) {
    fine_ = solve_at(true, nats);
    coarse_ = solve_at(false, nats);
    measure();
    if (difference_ <= enough) return;
  }
}

void SolvedNip::measure() {
  const std::vector<Float> fine = fine_->signature(), coarse = coarse_->signature();
  difference_ = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Float apart = abs(fine[i] - coarse[i]);
    if (!(apart <= difference_)) difference_ = apart;
  }
}

}  // namespace nipref::ref
