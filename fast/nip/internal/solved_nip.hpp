#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

/// The contact of a given length, or of the length that carries a given load: solved with as many terms as the accuracy
/// needs, once.
///
/// The length for a load is sought with few terms first, then by secants with all of them. Let A_0 and A_1 be the last two
/// half lengths, J_0 and J_1 a number of their contacts. For the half length A that the secant of the load shows, the number
/// is J_1 + (A - A_1) (J_1 - J_0)/(A_1 - A_0) up to (A - A_0) (A - A_1) J''/2. Numbers of a contact are nearly powers of A,
/// with exponents p between -5 and 5 (the load of an incompressible film without slip grows like A^5), so that |J''|/2 is at
/// most 15 |J|/A^2; that also holds for the length itself. A memory of rate r has changed by e^(-2 r A) over the contact. With
/// that as a factor |J''|/2 is |(p/A - 2 r)^2 - p/A^2| |J|/2, at most (5.5 + 2 |r| A)^2 |J|/(2 A^2), of which the memory
/// has left e^(-2 A Re r): more than 15 where it swings. The error of the number is that of its solution, this curvature,
/// and |dJ/dA| times the error of the length, which is that of the load over dW/dA.
class SolvedNip {
 public:
  using Number = std::function<Functional(const Solution&)>;

  SolvedNip(std::shared_ptr<const NipEquations> equations, double half_length, std::optional<double> load,
            double accuracy);

  [[nodiscard]] const NipEquations& equations() const { return *equations_; }
  [[nodiscard]] bool is_symmetric() const { return !equations_->offset_unknown(); }
  [[nodiscard]] const Solution& last() const { return *solution_; }
  /// Of the contact that carries the load; last() is next to it, as near as the search has come.
  [[nodiscard]] double half_length() const { return half_length_estimate().value; }
  [[nodiscard]] const Estimate& half_length_estimate() const;
  /// g at e >= 0, see Tractions; beyond the middle that of the other half.
  [[nodiscard]] std::complex<double> traction(double e) const;
  /// A number in last() and, for a given load, in the neighbour; `shift` is what the error of a place adds to its error.
  struct InBoth {
    Functional here;
    std::optional<Functional> there = {};
    double shift = 0;

    friend InBoth operator-(const InBoth& a, const InBoth& b);
  };
  [[nodiscard]] Estimate estimate(const InBoth& number) const;
  /// `number` gives the functional for a solution; in a contact of given load, for one of another length, too.
  [[nodiscard]] InBoth in_both(const Number& number) const;
  [[nodiscard]] Estimate estimate(const Number& number) const { return estimate(in_both(number)); }
  /// Numbers that are computed together at a place, which may be as far as `reach` from there.
  using AtPlace = std::function<std::vector<Functional>(const Solution&, const ContactPlace&)>;
  [[nodiscard]] std::vector<InBoth> at_place(const ContactPlace& place, double reach,
                                             const AtPlace& numbers) const;
  /// That of a place whose distance from the end is known to `unsure`.
  [[nodiscard]] static double reach(const ContactPlace& place, double unsure) {
    return unsure + 0x1p-52 * std::fabs(place.e);
  }
  /// Solves with more terms; false where rounding rules, so that more do not help.
  bool refine();

  [[nodiscard]] CountedKernels kernels() const { return {Accuracy(), *work_}; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  [[nodiscard]] std::unique_ptr<const Solution> solve(double half_length, const Resolution& resolution,
                                                      double tolerance = quadrature_tolerance) const;
  [[nodiscard]] std::unique_ptr<const Solution> solve(double half_length) const {
    return solve(half_length, equations_->resolution(nats_));
  }
  void solve_to(double nats);
  void search_roughly();
  void meet_load();
  /// Relative to the accuracy: 1 or less where all targets meet it; and the same of rounding alone.
  struct Shortfall {
    double all, rounding;
  };
  /// False where `enough` is met, or rounding rules whatever the panels are.
  bool add_terms(const Shortfall& now, double enough);
  [[nodiscard]] Shortfall shortfall() const;
  [[nodiscard]] const Solution& neighbour() const;
  /// A number of the contact of half_length() by its values in last() and the neighbour, and an error of it in last().
  [[nodiscard]] Estimate extrapolated(double here, double error, const std::function<double()>& there) const;
  /// A number's difference from the neighbour's, by the half length.
  [[nodiscard]] double growth(double here, double there) const;
  [[nodiscard]] double load_growth() const;
  /// What the curvature of a number may add to it in a contact of given load, relative to the number.
  [[nodiscard]] double curvature() const;

  std::shared_ptr<const NipEquations> equations_;
  std::optional<double> load_;
  double accuracy_;
  double near_;                           ///< the half length of the layout
  double longest_whole_ = longest_whole;  ///< less once rounding has asked for panels
  double sought_;                         ///< the best half length that is known
  double nats_ = 0;
  double exponent_;  ///< d ln load/d ln length
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::unique_ptr<const Solution> solution_;
  mutable std::unique_ptr<const Solution> neighbour_;
  mutable std::optional<Estimate> length_;
};

}  // namespace nipref::fast
