#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/layer.hpp>
#include <nipref/fast/number/internal/exponential_integrals.hpp>
#include <nipref/fast/viscoelastic_nip/internal/rolling_equations.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

/// int_0^x e^(-rate t) t^power dt over x^(power + 1), power = 0, 1, 2, as functions of z = rate x.
template <class Number>
std::array<Number, 3> faded_powers(Number z) {
  const Number end = std::exp(-z);
  std::array<Number, 3> sums{};
  if (std::abs(z) < 2) {
    // A series by parts gives the last integral; the recurrence backwards gives the others.
    constexpr double negligible = 0x1p-60;
    Number term = end / 3.0;
    for (double n = 4; std::norm(term) > negligible * negligible; ++n) {
      sums[2] += term;
      term *= z / n;
    }
    sums[1] = (end + z * sums[2]) / 2.0;
    sums[0] = end + z * sums[1];
    return sums;
  }
  sums[0] = (1.0 - end) / z;
  sums[1] = (sums[0] - end) / z;
  sums[2] = (2.0 * sums[1] - end) / z;
  return sums;
}

}  // namespace

RollingEquations::RollingEquations(RollingSheet sheet) : sheet_(std::move(sheet)), kernels_(sheet_) {}

Resolution RollingEquations::resolution(double nats) const {
  std::vector<Complex> rates;
  for (const Memory& memory : sheet_.normal.inverse) rates.push_back(memory.rate);
  return {nats, std::numbers::pi, 2, rates};
}

std::vector<RollingEquations::Mode> RollingEquations::modes(const std::vector<Panel>& panels) const {
  std::vector<Mode> result;
  int unknown = first_exponential, layers = 0;
  for (std::size_t j = 0; j < sheet_.normal.inverse.size(); ++j) {
    const Memory& memory = sheet_.normal.inverse[j];
    if (memory.rate.imag() < 0) continue;
    const int members = memory.rate.imag() > 0 ? 2 : 1;
    result.push_back({memory, j, members, unknown, is_layer(memory.rate, panels) ? layers++ : -1});
    unknown += members;
  }
  return result;
}

double RollingEquations::stiffness_of_layers(const std::vector<Mode>& modes) const {
  std::size_t layers = 0;
  for (const Mode& mode : modes)
    if (mode.is_layer()) layers = mode.number + static_cast<std::size_t>(mode.members);
  return sheet_.normal.stiffness[layers];
}

bool RollingEquations::has_faded(const Mode& mode, double half_length) {
  return mode.is_layer() || std::abs(mode.memory.rate) * half_length >= 1;
}

RollingEquations::Response RollingEquations::lasting_response(const std::vector<Mode>& modes,
                                                              double half_length) const {
  std::size_t faded = 0;
  Response result;
  for (const Mode& mode : modes) {
    const auto& [amplitude, rate] = mode.memory;
    const double members = mode.members;
    if (has_faded(mode, half_length)) faded = mode.number + static_cast<std::size_t>(mode.members);
    if (!mode.is_layer()) continue;
    result.first.add(members * (amplitude / rate / rate).real());
    result.second.add(members * (2.0 * amplitude / rate / rate / rate).real());
  }
  result.stiffness.add(sheet_.normal.stiffness[faded]);
  return result;
}

RollingEquations::Response RollingEquations::fading_response(const std::vector<Mode>& modes,
                                                             double half_length, double x) const {
  Response result;
  const auto add = [&](const Mode& mode, auto amplitude, auto rate) {
    const auto z = rate * x;
    const double members = mode.members;
    const auto faded = faded_powers(z);
    result.stiffness.add(members * std::real(has_faded(mode, half_length) ? -amplitude / rate * std::exp(-z)
                                                                          : amplitude * x * faded[0]));
    result.first.add(members * std::real(amplitude * x * x * faded[1]));
    result.second.add(members * std::real(amplitude * x * x * x * faded[2]));
  };
  for (const Mode& mode : modes) {
    const auto& [amplitude, rate] = mode.memory;
    if (mode.is_layer()) continue;
    if (rate.imag() == 0)
      add(mode, amplitude.real(), rate.real());
    else
      add(mode, amplitude, rate);
  }
  return result;
}

/// Adds the even part of the equations at the distance e from the two ends, and after it the odd part.
void RollingEquations::add_matching(const std::vector<Mode>& modes, double half_length, double e,
                                    Eigen::Index even_row, Equations& equations) const {
  const double y = half_length - e, trailing = 2 * half_length - e;
  const Response here = fading_response(modes, half_length, e),
                 there = fading_response(modes, half_length, trailing);
  const Response even = lasting_response(modes, half_length) + 0.5 * (here + there),
                 odd = 0.5 * (here + -1 * there);
  const double scale = stiffness_of_layers(modes);
  const Eigen::Index odd_row = even_row + 1;
  // The response to u, a polynomial. `flowing`: the coefficient of stiff_part if the layers leave no stiffness.
  const auto set_polynomial = [&](Eigen::Index row, const Response& own, const Response& other,
                                  double flowing) {
    const auto set = [&](int unknown, const Sized& coefficient) {
      equations.on_unknowns(row, unknown) = -coefficient.value;
      equations.size_on_unknowns(row, unknown) = coefficient.size;
    };
    const Sized of_offset = -2 * (y * other.stiffness + own.first),
                constant = -1 * (y * y * own.stiffness + 2 * y * other.first + own.second);
    set(stiff_part, !has_layers(modes) ? own.stiffness
                    : scale != 0       ? 1 / scale * own.stiffness
                                       : Sized{flowing, flowing});
    set(offset, of_offset);
    equations.right(row) = constant.value;
    equations.size_right(row) = constant.size;
  };
  set_polynomial(even_row, even, odd, 1);
  set_polynomial(odd_row, odd, even, 0);
  // The even and the odd part of e^(-rate e), the odd part without cancellation if the rate is small.
  const auto set_exponential = [&](const Mode& mode, auto rate) {
    const auto apart = 2 * y * rate, half = 0.5 * std::exp(-rate * e),
               difference = apart * internal::phi1(apart);
    const auto set = [&](Eigen::Index row, const Complex& part) {
      equations.on_unknowns(row, mode.unknown) = -mode.members * part.real();
      if (mode.members == 2) equations.on_unknowns(row, mode.unknown + 1) = 2 * part.imag();
    };
    set(even_row, half * (2.0 - difference));
    set(odd_row, half * difference);
  };
  for (const Mode& mode : modes) {
    if (const Complex rate = mode.memory.rate; rate.imag() == 0)
      set_exponential(mode, rate.real());
    else
      set_exponential(mode, rate);
  }
}

/// The memory of a term of N in the rows of RollingKernels::ahead: its real and its imaginary part.
static auto memory_of_term(const Eigen::MatrixXd& ahead, std::size_t term) {
  return ahead.middleRows(2 * static_cast<Eigen::Index>(term), 2);
}

/// Adds the equation of u_m: u = N(D) f at the leading end. It is scaled down so that the elimination uses it for u_m
/// alone. Otherwise its rounding would mix even and odd parts, one of which may be much smaller than the other.
void RollingEquations::add_middle_displacement(double half_length, const Eigen::MatrixXd& ahead,
                                               Equations& equations) const {
  const Eigen::Index row = equations.right.size() - 1;
  Eigen::RowVectorXd sum = ahead.bottomRows(1);
  for (std::size_t k = 0; k < sheet_.normal.terms.size(); ++k) {
    const auto& [amplitude, rate] = sheet_.normal.terms[k];
    const auto memory = memory_of_term(ahead, k);
    sum += (rate.imag() > 0 ? 2 : 1) * (amplitude.real() * memory.row(0) - amplitude.imag() * memory.row(1));
  }
  constexpr double scale = 0x1p-600;
  equations.on_tractions.row(row) = -scale * sum;
  equations.on_unknowns(row, equations.on_unknowns.cols() - 1) = scale;
  equations.on_unknowns(row, offset) = -2 * half_length * scale;
  equations.right(row) = half_length * half_length * scale;
}

/// Adds the equations of the exponentials' coefficients. A layer has the coefficient of its exponential.
void RollingEquations::add_closure(const std::vector<Mode>& modes, double half_length,
                                   const Eigen::MatrixXd& ahead, Equations& equations) const {
  const std::vector<Memory>& terms = sheet_.normal.terms;
  // The last equations are those of the unknowns from first_exponential on.
  const auto row_of = [&](const Mode& mode) {
    return equations.right.size() - equations.on_unknowns.cols() + mode.unknown;
  };
  for (const Mode& mode : modes) {
    const std::vector<Complex>& closure = sheet_.normal.closure[mode.number];
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const Complex rate = terms[k].rate;
      if (rate.imag() < 0) continue;
      // A pair's memories are conjugate.
      const auto partner = std::ranges::find(terms, std::conj(rate), &Memory::rate) - terms.begin();
      const Complex of_partner = rate.imag() > 0 ? closure[static_cast<std::size_t>(partner)] : 0;
      const Complex over = mode.is_layer() ? mode.memory.rate : 1;
      const Complex of_real = (closure[k] + of_partner) / over,
                    of_imaginary = Complex(0, 1) * (closure[k] - of_partner) / over;
      const auto memory = memory_of_term(ahead, mode.is_layer() ? terms.size() + k : k);
      const Eigen::Index row = row_of(mode);
      equations.on_tractions.row(row) -= of_real.real() * memory.row(0) + of_imaginary.real() * memory.row(1);
      if (mode.members == 2)
        equations.on_tractions.row(row + 1) -=
            of_real.imag() * memory.row(0) + of_imaginary.imag() * memory.row(1);
    }
  }
  for (const Mode& mode : modes) {
    for (int part = 0; part < mode.members; ++part) {
      const Eigen::Index row = row_of(mode) + part;
      equations.on_unknowns(row, mode.unknown + part) = 1;
      if (!mode.is_layer()) continue;
      equations.layers(2 * mode.layer + part, mode.unknown + part) = mode.members;
      const Complex of_offset = 2.0 * (mode.memory.amplitude / mode.memory.rate) / mode.memory.rate;
      const Complex constant = of_offset * (half_length + 1.0 / mode.memory.rate);
      equations.on_unknowns(row, offset) = -(part == 0 ? of_offset.real() : of_offset.imag());
      equations.right(row) = part == 0 ? constant.real() : constant.imag();
    }
  }
}

Solution RollingEquations::solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                 CountedKernels& kernels) const {
  const std::vector<Mode> modes = this->modes(panels);
  std::vector<Complex> layers;
  for (const Mode& mode : modes)
    if (mode.is_layer()) layers.push_back(mode.memory.rate);
  Tractions tractions(half_length, panels, true, 0.5, layers);
  const Tractions::SplitKernel elastic = frictionless_kernel(kernels);
  const auto [points, ahead, sizes] = tractions.matching_rows(elastic, tolerance);

  const auto matching = 2 * static_cast<Eigen::Index>(points.size());
  const auto memories = static_cast<int>(sheet_.normal.inverse.size() + (has_layers(modes) ? 1 : 0));
  const auto of_layers = static_cast<Eigen::Index>(2 * layers.size());
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(matching + memories, tractions.columns());
  Equations equations(none, none, first_exponential + memories, of_layers);
  // Layers act on the other half, too.
  const Eigen::MatrixXd behind =
      of_layers > 0 ? tractions.rows_of_layers_behind(points, elastic.whole, tolerance) : Eigen::MatrixXd();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i), row = 2 * at;
    for (std::size_t p = 0; p < panels.size(); ++p) {
      const int terms = panels[p].terms + Tractions::left_out;
      for (const int component : {0, 1}) {
        const auto columns = Eigen::seqN(tractions.column(p, component), terms);
        equations.on_tractions(row + component, columns) = ahead(at, columns);
        equations.size_on_tractions(row + component, columns) = sizes(at, columns);
      }
    }
    if (of_layers > 0) {
      const auto here = ahead.row(at).tail(of_layers);
      const auto there = behind.row(at);
      equations.on_tractions.row(row).tail(of_layers) = 0.5 * (here + there);
      equations.on_tractions.row(row + 1).tail(of_layers) = 0.5 * (here - there);
    }
    add_matching(modes, half_length, points[i], row, equations);
  }
  if (!modes.empty()) {
    const Eigen::MatrixXd ahead_of_end =
        tractions.rows(0, false, kernels_.ahead(has_layers(modes)), tolerance);
    add_closure(modes, half_length, ahead_of_end, equations);
    if (has_layers(modes)) add_middle_displacement(half_length, ahead_of_end, equations);
  }
  equations.memories = memories;
  return {std::move(tractions), equations};
}

std::vector<AccuracyTarget> RollingEquations::accuracy_targets(const Solution& solution) const {
  const double half_length = solution.half_length();
  return {{solution.of_unknown(middle_displacement(solution)), half_length * half_length},
          {solution.of_unknown(offset), 0.1 * half_length},
          {eccentricity(solution), 1e-4 * half_length}};
}

double RollingEquations::softening_over(double half_length) const {
  double sum = 1;
  for (const Memory& term : sheet_.normal.terms)
    sum += (term.amplitude / (term.rate + 1 / half_length)).real();
  return sum;
}

void RollingEquations::check(double half_length) const {
  constexpr double most = 3e4;
  const double softening = softening_over(half_length);
  if (!(softening <= most))
    throw data::BadInput(
        "nip.material", softening,
        "times as soft over the contact as at once, must be at most 3e4 times: with less at once "
        "the pressure at the leading end is nearly infinite");
}

/// u_m - y^2 + offset^2, y from the line through the centres.
Functional RollingEquations::roller_displacement(const Solution& solution, double y) const {
  const double middle = solution.unknown(offset);
  Functional result = solution.of_unknown(middle_displacement(solution));
  result.on_unknowns(offset) = 2 * middle;
  result.constant = -(y * y + middle * middle);
  return result;
}

/// The roller's displacement at y = offset + A or offset - A.
Functional RollingEquations::end_displacement(const Solution& solution, bool trailing) const {
  const double half_length = solution.half_length();
  Functional result = solution.of_unknown(middle_displacement(solution));
  result.on_unknowns(offset) = (trailing ? 2 : -2) * half_length;
  result.constant = -half_length * half_length;
  return result;
}

namespace {

/// The functionals of a kernel in which each functional is followed by the size of its parts.
std::vector<Functional> acting(const Solution& solution, const Tractions::Kernel& kernel,
                               const ContactPlace& place) {
  const auto [trailing, e] = place.from_nearer_end_of(solution);
  const Eigen::MatrixXd rows = solution.tractions().rows(e, trailing, kernel, quadrature_tolerance);
  std::vector<Functional> result;
  for (Eigen::Index i = 0; i < rows.rows(); i += 2) {
    result.push_back(solution.of_tractions(rows.row(i)));
    result.back().cancelled = solution.value(solution.of_tractions(rows.row(i + 1)));
  }
  return result;
}

}  // namespace

Functional RollingEquations::normal_displacement(const Solution& solution, const ContactPlace& place,
                                                 CountedKernels& /*kernels*/) const {
  return acting(solution, kernels_.normal(), place).front();
}

/// The displacement is relative to that far ahead.
AlongSurface RollingEquations::along_surface(const Solution& solution, const ContactPlace& place,
                                             CountedKernels& /*kernels*/) const {
  std::vector<Functional> both = acting(solution, kernels_.along(), place);
  const Functional pressure = traction(solution, TractionComponent::pressure, place);
  both[1].on_tractions -= sheet_.theta2_at_once * pressure.on_tractions;
  both[1].cancelled += std::fabs(sheet_.theta2_at_once * solution.value(pressure));
  return {std::move(both[0]), std::move(both[1])};
}

Functional RollingEquations::creep_ratio(const Solution& solution, CountedKernels& kernels) const {
  return 0.5 / solution.half_length() *
         (along_surface(solution, {false, 0}, kernels).displacement -
          along_surface(solution, {true, 0}, kernels).displacement);
}

}  // namespace nipref::fast
