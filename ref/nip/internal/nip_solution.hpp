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
  /// The effect of an end on the tractions falls as e^(-decay e) with the distance e from it, half-thicknesses.
  double decay;
  /// The tractions have exponentials e^(-rate e) as well. The first panel at an end is narrower by the factor `first`,
  /// at most 1, so that these exponentials hardly change on it.
  std::vector<std::complex<double>> rates;
  double first;
};

/// How finely a contact is cut into panels that grow from the end on.
struct Fineness {
  double first;   ///< largest width of the first panel, half-thicknesses, before Resolution::first
  double growth;  ///< distance of a panel's outer border from the end over that of its inner border
  double nats;    ///< the truncation error of the expansions is e^-nats
};
std::vector<TractionPanel> panels_of(const Float& half_length, const Resolution& resolution,
                                     const Fineness& fineness);

/// A solved contact of half length A (half-thicknesses), dimensionless: tractions times 2 R N/b, displacements times
/// 2 R/b^2, slopes times 2 R/b, with N at once. x is the distance behind the leading end. In the contact
/// u = edge_displacement + x (2A - x) + 2 offset x.
class NipSolution {
 public:
  virtual ~NipSolution() = default;
  NipSolution(const NipSolution&) = delete;
  NipSolution& operator=(const NipSolution&) = delete;
  /// The number of contacts solved so far in this program. Solving takes nearly all of its time.
  static long solved();

  [[nodiscard]] const Float& half_length() const { return tractions_.half_length(); }
  /// Distance of the contact's middle from the line through the rollers' centres, positive towards the leading side.
  [[nodiscard]] const Float& offset() const { return offset_; }
  [[nodiscard]] const Float& edge_displacement() const { return edge_displacement_; }
  [[nodiscard]] const Float& load() const { return load_; }
  /// Distance of the resultant from the line through the rollers' centres, with the same sign.
  [[nodiscard]] Float lever() const { return offset_ + moment_ / load_; }
  [[nodiscard]] const std::vector<TractionPanel>& panels() const { return tractions_.panels(); }
  /// Numbers by which two solutions are compared: the logarithms of load and length, and displacement, offset and
  /// tractions between the ends over the scales of their kinds.
  [[nodiscard]] std::vector<Float> signature() const;

  [[nodiscard]] PressureAndShear tractions(const Float& x) const;  ///< 0 outside the contact
  /// The tractions between the ends, from the distances from both ends.
  [[nodiscard]] PressureAndShear tractions(const Float& from_leading, const Float& from_trailing) const;

  /// d ln W/d ln A, from the coefficients of the powers with which the tractions vanish at the ends.
  [[nodiscard]] virtual Float growth() const = 0;
  [[nodiscard]] virtual Float normal(const Float& x) const = 0;
  /// The displacement upstream up to a constant, 0 in the middle of a contact without memory; strain() is its slope.
  [[nodiscard]] virtual Float tangential(const Float& x) const = 0;
  [[nodiscard]] virtual Float strain(const Float& x) const = 0;

 protected:
  NipSolution(Tractions tractions, SheetKernels& kernels);
  /// The displacement towards the middle plane in the contact.
  [[nodiscard]] Float on_roller(const Float& x) const;

  Tractions tractions_;
  SheetKernels& kernels_;
  /// Coefficients of the tractions on each half as functions of the distance from its end.
  Vector leading_, trailing_;
  Float edge_displacement_, load_, offset_ = 0, moment_ = 0;
};

/// The sheet of a nip, for SolvedNip.
class NipSheet {
 public:
  virtual ~NipSheet() = default;
  [[nodiscard]] virtual Resolution resolution() const = 0;
  /// The number of unknowns of a contact with `terms` terms on each half.
  [[nodiscard]] virtual int unknowns(int terms) const = 0;
  /// Digits that the solution loses by cancellation.
  [[nodiscard]] virtual int lost_digits() const { return 0; }
  /// BadInput for a half length (half-thicknesses) for which the sheet is not solved.
  virtual void check(double /*half_length*/) const {}
  /// Integrals are good to about e^-nats. The solution keeps references to the sheet and the kernels.
  [[nodiscard]] virtual std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                            std::vector<TractionPanel> panels, double nats,
                                                            SheetKernels& kernels) const = 0;
  [[nodiscard]] virtual bool sticks() const = 0;
  /// Whether both halves of a contact are alike.
  [[nodiscard]] virtual bool is_symmetric() const = 0;
  /// theta2/N, both at once.
  [[nodiscard]] virtual const Float& beta() const = 0;
};

/// The elastic sheet of a nip with full friction or none.
class ElasticSheet : public NipSheet {
 public:
  ElasticSheet(bool sticks, Float beta) : sticks_(sticks), beta_(std::move(beta)) {}

  [[nodiscard]] Resolution resolution() const override;
  [[nodiscard]] int unknowns(int terms) const override { return sticks_ ? 2 * terms + 2 : terms + 1; }
  [[nodiscard]] std::unique_ptr<NipSolution> solved(const Float& half_length,
                                                    std::vector<TractionPanel> panels, double nats,
                                                    SheetKernels& kernels) const override;
  [[nodiscard]] bool sticks() const override { return sticks_; }
  [[nodiscard]] bool is_symmetric() const override { return true; }
  [[nodiscard]] const Float& beta() const override { return beta_; }
  /// The epsilon of the power 1/2 - i epsilon with which tractions vanish at the ends: atanh(beta)/pi with friction.
  [[nodiscard]] Float epsilon() const;

 private:
  bool sticks_;
  Float beta_;
};

/// A contact solved twice, with different panels, numbers of terms and nodes. Both solutions are refined until they
/// agree to the requested digits. The result of a functional is that of the finer solution, with an error estimate:
/// ref/nip/README.md, Two solutions.
class SolvedNip {
 public:
  using Functional = std::function<Float(const NipSolution&)>;
  /// Throws for a half length that is not allowed.
  using Check = std::function<void(double half_length)>;
  using Sheet = std::shared_ptr<const NipSheet>;

  static SolvedNip of_half_length(const Sheet& sheet, const Float& half_length, int digits);
  /// The contact that carries the load. The search begins at the half length `guess`, which may be wrong by a factor.
  static SolvedNip of_load(const Sheet& sheet, const Float& load, double guess, int digits,
                           const Check& check);

  /// The number of unknowns of the finer of the first two solutions; BadInput if it is above the limit.
  static int first_unknowns(const NipSheet& sheet, const Float& half_length, int digits);
  static constexpr int working_digits(int digits, int lost_digits) { return digits + 14 + lost_digits; }
  /// The error of a small result is measured by its own size, but at least by this share of its kind's scale: at that
  /// size the kernels' errors are as large as a hundredth of its last digit.
  static Float kernel_share();

  [[nodiscard]] const NipSolution& fine() const { return *fine_; }
  [[nodiscard]] const NipSolution& coarse() const { return *coarse_; }
  [[nodiscard]] KernelValues kernel_values() const;  ///< of both solutions, so far
  [[nodiscard]] const Float& difference() const { return difference_; }
  [[nodiscard]] int unknowns() const;  ///< of the finer solution
  [[nodiscard]] data::WithError<Float> estimate(const Functional& functional, const Float& scale) const;

 private:
  SolvedNip(Sheet sheet, int digits);

  [[nodiscard]] std::unique_ptr<NipSolution> solution(const Float& half_length, bool fine, double nats) const;
  /// Refines the two solutions that solve_at(fine, nats) returns until they agree.
  void solve(const std::function<std::unique_ptr<NipSolution>(bool fine, double nats)>& solve_at);
  void measure();

  Sheet sheet_;
  int digits_;
  std::unique_ptr<SheetKernels> kernels_, coarse_kernels_;
  std::unique_ptr<NipSolution> coarse_, fine_;
  Float difference_ = 0;
};

}  // namespace nipref::ref
