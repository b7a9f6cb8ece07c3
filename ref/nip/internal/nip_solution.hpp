#pragma once
#include <complex>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <nipref/data/number/with_error.hpp>
#include <nipref/ref/nip/internal/tractions.hpp>

namespace nipref::ref {

/// What limits how fast the expansions of a contact converge.
struct Resolution {
  /// Of what an end causes in the tractions, e^(-decay e) is left at the distance e, half-thicknesses.
  double decay;
  /// The tractions have exponentials e^(-rate e), too. The first panel at an end has `first`, at most 1, of the width that
  /// it has without them, so that they hardly change on it.
  std::vector<std::complex<double>> rates;
  double first;
};

/// How finely a contact is cut into panels that grow from the end on.
struct Fineness {
  double first;   ///< width of the first one at most, half-thicknesses, but for Resolution::first
  double growth;  ///< where a panel ends over where it begins, as distances from the end
  double nats;    ///< what the expansions leave out is e^-nats
};
std::vector<TractionPanel> panels_of(const Float& half_length, const Resolution& resolution,
                                     const Fineness& fineness);

/// A solved contact of half length A (half-thicknesses), dimensionless: tractions times 2 R N/b, displacements times
/// 2 R/b^2, slopes times 2 R/b, with N at once. x is the way behind the leading end. In the contact
/// u = edge_displacement + x (2A - x) + 2 offset x.
class NipSolution {
 public:
  virtual ~NipSolution() = default;
  NipSolution(const NipSolution&) = delete;
  NipSolution& operator=(const NipSolution&) = delete;
  /// How many this program has solved so far: nearly all of the work.
  static long solved();

  [[nodiscard]] const Float& half_length() const { return tractions_.half_length(); }
  /// Of the middle of the contact from the line through the rollers' centres, towards the leading side.
  [[nodiscard]] const Float& offset() const { return offset_; }
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }
  [[nodiscard]] const Float& load() const { return load_; }
  /// Of the resultant from the line through the centres.
  [[nodiscard]] Float lever() const { return offset_ + moment_ / load_; }
  [[nodiscard]] const std::vector<TractionPanel>& panels() const { return tractions_.panels(); }
  /// Load, length, displacement, offset and tractions at places between the ends, over the scales of their kinds;
  /// logarithms of the first two. They differ by what solutions differ by, relative to the scales.
  [[nodiscard]] std::vector<Float> signature() const;

  [[nodiscard]] PressureAndShear tractions(const Float& x) const;  ///< 0 outside the contact
  /// The same between the ends, by the distances from both.
  [[nodiscard]] PressureAndShear tractions(const Float& from_leading, const Float& from_trailing) const;

  /// d ln W/d ln A: dW/dA goes with the square of how the tractions' derivatives grow at the ends.
  [[nodiscard]] virtual Float growth() const = 0;
  [[nodiscard]] virtual Float normal(const Float& x) const = 0;
  /// Upstream, up to a constant, which is 0 in the middle of a contact without memory; and its slope upstream.
  [[nodiscard]] virtual Float tangential(const Float& x) const = 0;
  [[nodiscard]] virtual Float strain(const Float& x) const = 0;

 protected:
  NipSolution(Tractions tractions, SheetKernels& kernels);
  /// The displacement towards the middle plane in the contact.
  [[nodiscard]] Float on_roller(const Float& x) const;

  Tractions tractions_;
  SheetKernels& kernels_;
  /// Coefficients of the tractions on both halves, by the distance from their ends.
  Vector leading_, trailing_;
  Float edge_displacement_, load_, offset_ = 0, moment_ = 0;
};

/// The sheet of a nip, for SolvedNip.
class NipSheet {
 public:
  virtual ~NipSheet() = default;
  [[nodiscard]] virtual Resolution resolution() const = 0;
  /// Of a contact of which each half has so many terms.
  [[nodiscard]] virtual int unknowns(int terms) const = 0;
  /// Digits that are lost as parts of the solution cancel.
  [[nodiscard]] virtual int lost_digits() const { return 0; }
  /// BadInput for half lengths (half-thicknesses) of which the sheet is not solved.
  virtual void check(double /*half_length*/) const {}
  /// Integrals are good to about e^-nats. The solution refers to the sheet and the kernels.
  [[nodiscard]] virtual std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                            std::vector<TractionPanel> panels, double nats,
                                                            SheetKernels& kernels) const = 0;
  [[nodiscard]] virtual bool grips() const = 0;
  /// Whether both halves of a contact are alike.
  [[nodiscard]] virtual bool is_symmetric() const = 0;
  /// Of theta2 at once over N.
  [[nodiscard]] virtual const Float& beta() const = 0;
};

/// The elastic sheet of a nip with full friction or none.
class ElasticSheet : public NipSheet {
 public:
  ElasticSheet(bool grips, Float beta) : grips_(grips), beta_(std::move(beta)) {}

  [[nodiscard]] Resolution resolution() const override;
  [[nodiscard]] int unknowns(int terms) const override { return grips_ ? 2 * terms + 2 : terms + 1; }
  [[nodiscard]] std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                    std::vector<TractionPanel> panels, double nats,
                                                    SheetKernels& kernels) const override;
  [[nodiscard]] bool grips() const override { return grips_; }
  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] const Float& beta() const override { return beta_; }
  /// Of the power 1/2 - i epsilon with which the tractions vanish at the ends: atanh(beta)/pi with full friction.
  [[nodiscard]] Float epsilon() const;

 private:
  bool grips_;
  Float beta_;
};

/// A contact solved twice, with other panels, other numbers of terms and other nodes, and again with more of them until both
/// agree to the digits asked for. The result of a functional is that of the finer solution, with an error that is estimated:
/// ref/nip/README.md, Two solutions.
class SolvedNip {
 public:
  using Functional = std::function<Float(const NipSolution&)>;
  /// Throws for a half length that is not allowed.
  using Check = std::function<void(double half_length)>;
  using Sheet = std::shared_ptr<const NipSheet>;

  static SolvedNip of_half_length(const Sheet& sheet, const Float& half_length, int digits);
  /// Of the load, by a search that begins at the half length `guess`, which may be wrong by a factor.
  static SolvedNip of_load(const Sheet& sheet, const Float& load, double guess, int digits,
                           const Check& check);

  /// The unknowns of the finer of the first two solutions; BadInput if these are more than are tried.
  static int first_unknowns(const NipSheet& sheet, const Float& half_length, int digits);
  static constexpr int working_digits(int digits, int lost_digits) { return digits + 14 + lost_digits; }
  /// The part of its kind's scale that a small result, which is measured by itself, is measured by at least: the kernels'
  /// errors are smaller than a hundredth of the last digit by that factor.
  static Float kernel_share();

  [[nodiscard]] const NipSolution& fine() const { return *fine_; }
  [[nodiscard]] const NipSolution& coarse() const { return *coarse_; }
  [[nodiscard]] SheetKernels& kernels() const { return *kernels_; }
  [[nodiscard]] const Float& difference() const { return difference_; }
  [[nodiscard]] int unknowns() const;  ///< of the finer solution
  [[nodiscard]] data::WithError<Float> estimate(const Functional& functional, const Float& scale) const;

 private:
  SolvedNip(Sheet sheet, int digits);

  [[nodiscard]] std::unique_ptr<NipSolution> solution(const Float& half_length,
                                                      const Fineness& fineness) const;
  /// By solve_at(fineness).
  void solve(const std::function<std::unique_ptr<NipSolution>(const Fineness&)>& solve_at);
  void measure();

  Sheet sheet_;
  int digits_;
  std::unique_ptr<SheetKernels> kernels_;
  std::unique_ptr<NipSolution> coarse_, fine_;
  Float difference_ = 0;
};

}  // namespace nipref::ref
