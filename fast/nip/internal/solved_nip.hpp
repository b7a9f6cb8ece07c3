#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

/// The solved contact of a given length, or of the length that carries a given load, with the terms for an accuracy.
///
/// The length for a load is sought with few terms first, then by secants with all terms. Let A_0 and A_1 be the last
/// two half-lengths, J_0 and J_1 a number of their contacts. At the half-length A to which the secant of the load
/// leads, the number is J_1 + (A - A_1) (J_1 - J_0)/(A_1 - A_0) up to the curvature (A - A_0) (A - A_1) J''/2. Numbers
/// of a contact are nearly powers of A with exponents p between -5 and 5 (the load of an incompressible film without
/// slip grows like A^5), so that |J''|/2 is at most 15 |J|/A^2. This also holds for the length itself. A memory of rate
/// r changes by the factor e^(-2 r A) over the contact. For a number with this factor |J''|/2 is
/// |(p/A - 2 r)^2 - p/A^2| |J|/2, at most (5.5 + 2 |r| A)^2 |J|/(2 A^2), times e^(-2 A Re r) because the memory fades.
/// This exceeds 15 |J|/A^2 if the memory oscillates. Besides this curvature, the errors e of J_1 and w of its load, about
/// those of the neighbour J_0, too, as both have the same panels, make the number wrong by at most
///     (|1 - t| + |t|) (e + |dJ/dA| w/(dW/dA)),  t = (A - A_1)/(A_0 - A_1),
/// with the true slopes. Truncation errors are nearly equal in both contacts; those of rounding, e' and w', are not, so
/// that the slope of a secant is wrong by up to 2 e'/|A_0 - A_1| or 2 w'/|A_0 - A_1|.
///
/// Results are computed when they are asked for; what they share is kept. There is no lock: only one thread at a time may
/// call the members of an object, const ones, too. Different objects may be used at the same time.
class SolvedNip {
 public:
  using Number = std::function<Functional(const Solution&)>;

  SolvedNip(std::shared_ptr<const NipEquations> equations, double half_length, std::optional<double> load,
            double accuracy);

  [[nodiscard]] const NipEquations& equations() const { return *equations_; }
  [[nodiscard]] bool is_symmetric() const { return !equations_->offset_unknown(); }
  [[nodiscard]] const Solution& last() const { return *solution_; }
  /// The half-length of the contact that carries the load. last() is as close to this contact as the search has come.
  [[nodiscard]] double half_length() const { return half_length_estimate().value; }
  [[nodiscard]] const Estimate& half_length_estimate() const;
  /// g at e >= 0, see Tractions; beyond the middle g of the other half.
  [[nodiscard]] std::complex<double> traction(double e) const;
  /// A number in last() and, for a given load, in the neighbour. `shift` is the error that the error of a place causes.
  struct InBoth {
    Functional here;
    std::optional<Functional> there = {};
    double shift = 0;

    friend InBoth operator-(const InBoth& a, const InBoth& b);
  };
  [[nodiscard]] Estimate estimate(const InBoth& number) const;
  /// `number` returns the functional for a solution. If the load is given, it is called for the neighbour, too.
  [[nodiscard]] InBoth in_both(const Number& number) const;
  [[nodiscard]] Estimate estimate(const Number& number) const { return estimate(in_both(number)); }
  /// Numbers that are computed together at a place. The true place is at most `reach` away.
  using AtPlace = std::function<std::vector<Functional>(const Solution&, const ContactPlace&)>;
  [[nodiscard]] std::vector<InBoth> at_place(const ContactPlace& place, double reach,
                                             const AtPlace& numbers) const;
  /// The reach of a place whose distance from the end has the error `unsure`. The distance also has three roundings of
  /// 2^-53: those of Y in half-thicknesses, of its distance from the middle and of the difference from the half-length.
  [[nodiscard]] static double reach(const ContactPlace& place, double unsure) {
    return unsure + 3 * 0x1p-53 * std::fabs(place.e);
  }
  /// Solves with more terms. Returns false if rounding dominates, so that more terms do not help.
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
  /// The targets' largest error over the accuracy, 1 or less if all meet it; and their largest rounding error over it.
  struct Shortfall {
    double all, rounding;
  };
  /// Solves with more terms or panels. Returns false if `now.all` is `enough` or rounding dominates with any panels.
  bool add_terms(const Shortfall& now, double enough);
  [[nodiscard]] Shortfall shortfall() const;
  [[nodiscard]] const Solution& neighbour() const;
  /// How much longer the neighbour's half-length is than that of last().
  [[nodiscard]] double to_neighbour() const;
  [[nodiscard]] double load_growth() const;
  /// |1 - t| + |t|.
  [[nodiscard]] double parts_of_both() const;
  /// The error that the curvature of a number may cause in a contact of given load, relative to the number.
  [[nodiscard]] double curvature() const;

  std::shared_ptr<const NipEquations> equations_;
  std::optional<double> load_;
  double accuracy_;
  double near_;                           ///< the half-length for which the panels are laid out
  double longest_whole_ = longest_whole;  ///< less once rounding has required several panels
  double sought_;                         ///< the best half-length found so far
  double nats_ = 0;
  double exponent_;                                        ///< d ln load/d ln length
  std::unique_ptr<Work> work_ = std::make_unique<Work>();  ///< grows in const members, too
  std::unique_ptr<const Solution> solution_;
  /// A_0 of a given load: the last but one contact of the search or, when a number first needs it, a slightly longer one.
  mutable std::unique_ptr<const Solution> neighbour_;
  mutable std::optional<Estimate>
      length_;  ///< kept by half_length_estimate() until there is another solution
};

}  // namespace nipref::fast
