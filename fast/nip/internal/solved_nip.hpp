#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/nip/internal/panels.hpp>
#include <nipref/fast/nip/internal/solution.hpp>

namespace nipref::fast {

/// A number that has to meet the accuracy, relative to `scale` or to its value if that is larger.
struct AccuracyTarget {
  Functional number;
  double scale = 0;
};

/// What is special to a kind of nip, dimensionless: lengths in half-thicknesses b, tractions times 2 R N/b, displacements
/// times 2 R/b^2, loads times 2 R N/b^2, N the compliance of the normal displacement (at once).
class NipEquations {
 public:
  virtual ~NipEquations() = default;
  /// The resolution of a contact of half length A whose coefficients are to fall to e^-nats.
  [[nodiscard]] virtual Resolution resolution(double nats) const = 0;
  /// tolerance: of the quadratures.
  [[nodiscard]] virtual Solution solve(double half_length, const std::vector<Panel>& panels, double tolerance,
                                       CountedKernels& kernels) const = 0;
  /// Beside the load.
  [[nodiscard]] virtual std::vector<AccuracyTarget> accuracy_targets(const Solution& solution) const = 0;
  /// Where the search for the length begins.
  [[nodiscard]] virtual double half_length_guess(double load) const = 0;
};

/// The contact of a given length, or of the length that carries a given load: solved with as many terms as the accuracy
/// needs, once.
///
/// The length for a load is sought with few terms first, then by secants with all of them. A number J of a contact of
/// given load is corrected by dJ/dA for what the search has left of the load, and has the error of its solution and
/// |dJ/dA| dA. There dA = dW/(dW/dA), dW the error of the load and all that the search has left of it, which is much more
/// than what the correction to first order leaves. Derivatives with respect to the half length A are differences from a
/// contact of another length, one that the search has passed or one that is longer by a thousandth. They are powers of A
/// nearly, also in a long contact, if places keep their distance from the contact's end.
class SolvedNip {
 public:
  using Number = std::function<Functional(const Solution&)>;

  SolvedNip(std::shared_ptr<const NipEquations> equations, double half_length, std::optional<double> load,
            double accuracy);

  [[nodiscard]] const Solution& last() const { return *solution_; }
  /// Of the contact that carries the load, from which last() differs by what the search has left.
  [[nodiscard]] double half_length() const { return half_length_estimate().value; }
  [[nodiscard]] const Estimate& half_length_estimate() const;
  /// `number` gives a number of a solution; the value is that of the contact of half_length().
  [[nodiscard]] double value(const std::function<double(const Solution&)>& number) const;
  /// `number` gives the functional for a solution; in a contact of given load, for one of another length, too.
  [[nodiscard]] Estimate estimate(const Number& number) const;
  /// The same for a number that is a function of linear ones.
  [[nodiscard]] Estimate estimate(const Number& linearised,
                                  const std::function<double(const Solution&)>& number) const;
  /// A number of a place at the distance e from an end, negative outside the contact, where e is known to `unsure`.
  using AtPlace = std::function<Functional(const Solution&, double e)>;
  [[nodiscard]] Estimate at_place(double e, double unsure, const AtPlace& number) const;
  /// How much such a number may change because the place is not known better.
  [[nodiscard]] double shift(double e, double unsure, const AtPlace& number) const;
  /// Solves with more terms; false where rounding rules, so that more do not help.
  bool refine();

  /// Of the quadratures, whose error is less than that of rounding.
  static constexpr double tolerance() { return 1e-16; }
  [[nodiscard]] CountedKernels kernels() const { return {Accuracy(), *work_}; }
  [[nodiscard]] const Work& work() const { return *work_; }

 private:
  [[nodiscard]] std::unique_ptr<const Solution> solve(double half_length, double nats,
                                                      double tolerance = SolvedNip::tolerance()) const;
  void solve_to(double nats);
  void solve_for_load(double nats);
  /// Relative to the accuracy: 1 or less where all targets meet it; and the same of rounding alone.
  struct Shortfall {
    double all, rounding;
  };
  [[nodiscard]] Shortfall shortfall() const;
  [[nodiscard]] const Solution& neighbour() const;
  /// A number's difference from the neighbour's, by the half length.
  [[nodiscard]] double growth(const std::function<double(const Solution&)>& value) const;

  std::shared_ptr<const NipEquations> equations_;
  std::optional<double> load_;
  double accuracy_;
  double near_;  ///< half length
  double nats_ = 0;
  double exponent_;  ///< d ln load/d ln length
  std::unique_ptr<Work> work_ = std::make_unique<Work>();
  std::unique_ptr<const Solution> solution_;
  mutable std::unique_ptr<const Solution> neighbour_;
  mutable std::optional<Estimate> length_;
};

}  // namespace nipref::fast
