#include <algorithm>
#include <cmath>

#include <nipref/fast/nip/internal/expansion_tail.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>
#include <nipref/fast/viscoelastic_nip/internal/basis.hpp>
#include <nipref/fast/viscoelastic_nip/internal/operator.hpp>
#include <nipref/fast/viscoelastic_nip/internal/pressure.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

}  // namespace

ViscoelasticPressure::ViscoelasticPressure(const ViscoelasticLayout& layout,
                                           const ViscoelasticCompliances& material, double tolerance,
                                           CountedKernels& kernels)
    : layout_(layout) {
  std::vector<TermMemory> memory;
  for (const MemoryTerm& term : material.normal) {
    memory.push_back({term, {}});
    for (const ViscoelasticPanel& panel : layout.panels())
      memory.back().on_panel.push_back(panel_memory(layout, panel, term.rate));
  }
  const SolutionAndTwins found = solutions(memory, tolerance, kernels);
  take(material, memory, found.solution);
  tails_ = expansion_tails(found, layout.terms(), static_cast<Eigen::Index>(layout.panels().size()));
  for (const auto& twin : found.twins.colwise())
    twins.push_back(
        std::unique_ptr<ViscoelasticPressure>(new ViscoelasticPressure(layout, material, memory, twin)));
}

ViscoelasticPressure::ViscoelasticPressure(const ViscoelasticLayout& layout,
                                           const ViscoelasticCompliances& material,
                                           const std::vector<TermMemory>& memory,
                                           const Eigen::VectorXd& unknowns)
    : layout_(layout) {
  take(material, memory, unknowns);
}

void ViscoelasticPressure::take(const ViscoelasticCompliances& material,
                                const std::vector<TermMemory>& memory, const Eigen::VectorXd& unknowns) {
  unknowns_ = unknowns;
  edge_displacement_ = unknowns_(unknowns_.size() - 2);
  offset_ = unknowns_(unknowns_.size() - 1);
  integrate();
  normal_response_ = response(1, material.normal, memory);
  theta2_response_ = response(material.theta2_instantaneous, material.theta2, memory);
}

/// Each row is u at a matching point. What leaves a panel acts through the panels downstream of it and, at
/// last, through the trail: it is gathered upstream, so that a row costs no more than its own length.
SolutionAndTwins ViscoelasticPressure::solutions(const std::vector<TermMemory>& terms, double tolerance,
                                                 CountedKernels& kernels) const {
  ViscoelasticOperator from(layout_, tolerance, kernels);
  const auto points = layout_.matching_points();
  const auto rows = static_cast<Eigen::Index>(points.size());
  const auto& panels = layout_.panels();

  std::vector<Eigen::VectorXcd> by_outflow;  // of each term's memory behind the panel at hand
  for (const TermMemory& block : terms) {
    by_outflow.push_back(Eigen::VectorXcd::NullaryExpr(rows, [&](Eigen::Index i) {
      return from.trail(points[static_cast<std::size_t>(i)], block.term.rate, ViscoelasticKernel::normal);
    }));
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, rows);
  for (std::size_t p = panels.size(); p-- > 0;) {
    const Eigen::MatrixXd moments = from.moments(points, panels[p], ViscoelasticKernel::normal);
    Eigen::MatrixXd to_response = pressure_in_chebyshev(layout_, panels[p]);
    auto columns = matrix.middleCols(static_cast<Eigen::Index>(p) * layout_.terms(), layout_.terms());
    for (std::size_t r = 0; r < terms.size(); ++r) {
      const PanelMemory& memory = terms[r].on_panel[p];
      const Complex amplitude = terms[r].term.amplitude;
      to_response += (amplitude * memory.by_pressure).real();
      columns += (amplitude * by_outflow[r] * memory.outflow_by_pressure).real();
      by_outflow[r] = (moments * memory.by_inflow + memory.outflow_by_inflow * by_outflow[r]).eval();
    }
    columns += product(moments, to_response);
  }
  Eigen::VectorXd gap(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double d = layout_.downstream(points[static_cast<std::size_t>(i)]);
    const double e = points[static_cast<std::size_t>(i)].e;
    gap(i) = e * (2 * half_length() - e);
    matrix(i, rows - 2) = -1;
    matrix(i, rows - 1) = -2 * d;
  }
  kernels.count_system(static_cast<int>(rows));
  // Entries with memory are sums over panels and trail, of which large parts cancel (measured).
  return solution_and_twins(matrix, terms.empty() ? matrix : Eigen::MatrixXd(2 * matrix), gap);
}

Eigen::VectorXd ViscoelasticPressure::coefficients(std::size_t panel) const {
  return unknowns_.segment(static_cast<Eigen::Index>(panel) * layout_.terms(), layout_.terms());
}

ViscoelasticPressure::Response ViscoelasticPressure::response(double instantaneous,
                                                              const std::vector<MemoryTerm>& terms,
                                                              const std::vector<TermMemory>& memory) const {
  Response result;
  const auto& panels = layout_.panels();
  for (std::size_t p = 0; p < panels.size(); ++p)
    result.on_panel.push_back(instantaneous * (pressure_in_chebyshev(layout_, panels[p]) * coefficients(p)));
  for (const MemoryTerm& term : terms) {
    const auto same_rate =
        std::ranges::find(memory, term.rate, [](const TermMemory& other) { return other.term.rate; });
    Complex inflow = 0;
    for (std::size_t p = 0; p < panels.size(); ++p) {
      const PanelMemory& on_panel = same_rate->on_panel[p];
      const Eigen::VectorXcd z = on_panel.by_pressure * coefficients(p) + on_panel.by_inflow * inflow;
      result.on_panel[p] += (term.amplitude * z).real();
      inflow = (on_panel.outflow_by_pressure * coefficients(p))(0) + on_panel.outflow_by_inflow * inflow;
    }
    result.trailing.push_back({term.amplitude * inflow, term.rate});
  }
  return result;
}

void ViscoelasticPressure::integrate() {
  const auto& panels = layout_.panels();
  for (std::size_t p = 0; p < panels.size(); ++p) {
    const ViscoelasticPanel& panel = panels[p];
    const auto basis = viscoelastic_basis(layout_.terms(), panel.at_end());
    const Eigen::VectorXd c = coefficients(p);
    const double sum = panel.width * (basis->integral * c)(0);
    const double from_end = panel.left * sum + panel.width * panel.width * (basis->moment * c)(0);
    const double first = half_length() * sum - from_end;
    load_ += sum;
    moment_ += panel.half == Half::leading ? first : -first;
  }
}

ContactPlace ViscoelasticPressure::place(double y) const {
  const double from_middle = y - offset_;
  return {from_middle >= 0 ? Half::leading : Half::trailing, half_length() - std::fabs(from_middle)};
}

double ViscoelasticPressure::pressure(ContactPlace place) const {
  const std::size_t p = layout_.panel_of(place);
  const ViscoelasticPanel& panel = layout_.panels()[p];
  std::vector<double> basis;
  layout_.pressure_basis(panel, panel.xi((place.e - panel.left) / panel.width), basis);
  return Eigen::Map<Eigen::VectorXd>(basis.data(), layout_.terms()).dot(coefficients(p));
}

double ViscoelasticPressure::normal_displacement(ContactPlace place, double tolerance,
                                                 CountedKernels& kernels) const {
  const double d = layout_.downstream(place);
  if (place.e >= 0) return edge_displacement_ + place.e * (2 * half_length() - place.e) + 2 * offset_ * d;
  ViscoelasticOperator from(layout_, tolerance, kernels);
  double sum = 0;
  for (std::size_t p = 0; p < layout_.panels().size(); ++p)
    sum += (from.moments({place}, layout_.panels()[p], ViscoelasticKernel::normal) *
            normal_response_.on_panel[p])(0);
  for (const MemoryTerm& term : normal_response_.trailing)
    sum += (term.amplitude * from.trail(place, term.rate, ViscoelasticKernel::normal)).real();
  return sum;
}

double ViscoelasticPressure::tangential_part(const Response& response, ViscoelasticKernel kernel,
                                             ContactPlace place, ContactPlace reference,
                                             ViscoelasticOperator& from) const {
  double sum = 0;
  for (std::size_t p = 0; p < layout_.panels().size(); ++p) {
    const Eigen::VectorXd both =
        from.moments({place, reference}, layout_.panels()[p], kernel) * response.on_panel[p];
    sum += both(0) - both(1);
  }
  for (const MemoryTerm& term : response.trailing)
    sum +=
        (term.amplitude * (from.trail(place, term.rate, kernel) - from.trail(reference, term.rate, kernel)))
            .real();
  return sum;
}

double ViscoelasticPressure::tangential_displacement(ContactPlace place, ContactPlace reference,
                                                     double tolerance, CountedKernels& kernels) const {
  ViscoelasticOperator from(layout_, tolerance, kernels);
  return tangential_part(normal_response_, ViscoelasticKernel::tangential, place, reference, from) -
         tangential_part(theta2_response_, ViscoelasticKernel::sign, place, reference, from);
}

double ViscoelasticPressure::value(const Response& response, ContactPlace place) const {
  if (place.e < 0) {
    if (place.half == Half::leading) return 0;
    double sum = 0;
    for (const MemoryTerm& term : response.trailing)
      sum += (term.amplitude * std::exp(term.rate * place.e)).real();
    return sum;
  }
  const std::size_t p = layout_.panel_of(place);
  const ViscoelasticPanel& panel = layout_.panels()[p];
  std::vector<double> polynomials(static_cast<std::size_t>(response.on_panel[p].size()));
  internal::shifted_chebyshev(panel.xi((place.e - panel.left) / panel.width), polynomials);
  return Eigen::Map<Eigen::VectorXd>(polynomials.data(), response.on_panel[p].size())
      .dot(response.on_panel[p]);
}

/// I2' is pi times the place itself.
double ViscoelasticPressure::strain(ContactPlace place, double tolerance, CountedKernels& kernels) const {
  ViscoelasticOperator from(layout_, tolerance, kernels);
  double sum = -value(theta2_response_, place);
  for (std::size_t p = 0; p < layout_.panels().size(); ++p)
    sum += (from.moments({place}, layout_.panels()[p], ViscoelasticKernel::stretch) *
            normal_response_.on_panel[p])(0);
  for (const MemoryTerm& term : normal_response_.trailing)
    sum += (term.amplitude * from.trail(place, term.rate, ViscoelasticKernel::stretch)).real();
  return sum;
}

/// I3 is at most half of I2.
double ViscoelasticPressure::tangential_size(double tolerance, CountedKernels& kernels) const {
  ViscoelasticOperator from(layout_, tolerance, kernels);
  const auto over_contact = [&](const Response& response) {
    return std::fabs(
        tangential_part(response, ViscoelasticKernel::sign, {Half::leading, 0}, {Half::trailing, 0}, from));
  };
  return over_contact(normal_response_) / 2 + over_contact(theta2_response_);
}

}  // namespace nipref::fast
