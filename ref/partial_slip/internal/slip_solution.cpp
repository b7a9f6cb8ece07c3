#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_slopes.hpp>
#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

using Zones = Row<SlipZone>;

constexpr int most_newton_steps = 40, most_corrections = 8;
/// Digits of the grid on which zones are first sought, and of both grids beyond those asked for.
constexpr int first_digits = 6, coarse_guard = 3, fine_guard = 5;
/// A relative change of a zone's length. Next to ends slopes have lost three digits in double, which leaves seven of their change.
constexpr double step_of_lengths = 1e-6;
/// Of a zone's length in a step of Newton's method, as a logarithm.
constexpr double most_change = 0.7;
/// A residual that is so much smaller after a step: the slopes are renewed if it is not.
constexpr double slow_convergence = 0.01;

Eigen::VectorXd in_double(const Vector& x, const Float& unit) {
  Eigen::VectorXd result(x.size());
  for (GridIndex i = 0; i < x.size(); ++i) result(i) = static_cast<double>(Float(x(i) / unit));
  return result;
}

Float length_of(const Zones& zones) {
  Float sum = 0;
  for (const SlipZone& zone : zones) sum += zone.length;
  return sum;
}

/// Appends to the last zone if that has the same sign; between slip of opposite signs there is stick.
void add_zone(Zones& zones, int sign, const Float& length) {
  if (!zones.empty() && zones.back().sign == sign) {
    zones.back().length += length;
    return;
  }
  if (!zones.empty() && zones.back().sign * sign < 0)
    zones.push_back({0, std::min(zones.back().length, length) / 8});
  zones.push_back({sign, length});
}

/// Newton's method for the unknowns and the logarithms of the zones' lengths together.
class Newton {
 public:
  Newton(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels, const Zones& zones)
      : grid_(std::move(grid)), kernels_(kernels), zones_(zones) {
    renew();
    unknowns_ = Vector(contact_->sizes().count());
  }

  /// The tractions of `near`, or of least squares.
  void begin(const SlipField* near) {
    if (near != nullptr) {
      unknowns_ = contact_->unknowns_of(*near);
      evaluate();
      return;
    }
    evaluate();
    const Float size = largest_entry(rest_);
    const Eigen::MatrixXd system = slopes(*contact_);
    change_unknowns(system.leftCols(unknowns_.size()).colPivHouseholderQr().solve(in_double(rest_, size)),
                    size);
    evaluate();
  }

  /// Whether it converges. Where a zone vanishes it does not, and the zones are without it.
  bool converges() {
    if (rest_.size() != unknowns_.size() + zones_.count()) return false;
    const Float enough = exp(Float(-grid_->nats())) / 100 * grid_->problem().unit;
    bool is_new = true;
    for (int step = 0; step < most_newton_steps; ++step) {
      const Float size = largest_entry(rest_);
      if (size < enough) return true;
      if (is_new) make_slopes();
      const Eigen::VectorXd change = eliminated_.solve(in_double(rest_, size));
      if (!change.allFinite()) return false;
      const double most = change.tail(zones_.count()).cwiseAbs().maxCoeff() * static_cast<double>(size);
      const Float part = size * std::min(1.0, most_change / most);
      change_unknowns(change, part);
      for (GridIndex i = 0; i < zones_.count(); ++i)
        zones_[i].length *= exp(Float(-part * change(unknowns_.size() + i)));
      if (drops_zone()) return false;
      renew();
      evaluate();
      is_new = largest_entry(rest_) > size * slow_convergence;
    }
    return false;
  }

  [[nodiscard]] const Zones& zones() const { return zones_; }
  [[nodiscard]] std::unique_ptr<const SlipContact> result() { return std::move(contact_); }

 private:
  void evaluate() {
    contact_->set(unknowns_);
    rest_ = contact_->residual();
  }

  void renew() { contact_ = std::make_unique<SlipContact>(grid_, kernels_, zones_); }

  void change_unknowns(const Eigen::VectorXd& change, const Float& part) {
    for (GridIndex i = 0; i < unknowns_.size(); ++i) unknowns_(i) -= part * change(i) * contact_->sizes()[i];
  }

  void make_slopes() {
    const GridIndex linear = unknowns_.size();
    const Eigen::MatrixXd system = slopes(*contact_);
    Eigen::VectorXd values(linear + 1);
    for (GridIndex i = 0; i < linear; ++i)
      values(i) = static_cast<double>(Float(unknowns_(i) / contact_->sizes()[i]));
    values(linear) = 1;
    Eigen::MatrixXd matrix(system.rows(), system.rows());
    matrix.leftCols(linear) = system.leftCols(linear);
    for (GridIndex i = 0; i < zones_.count(); ++i) {
      Zones longer = zones_;
      longer[i].length *= 1 + step_of_lengths;
      const Eigen::MatrixXd change = slopes(SlipContact(grid_, kernels_, longer)) - system;
      matrix.col(linear + i) = change * values / step_of_lengths;
    }
    eliminated_.compute(matrix);
  }

  /// A zone too short to matter.
  bool drops_zone() {
    const Float least = length_of(zones_) * exp(Float(-grid_->nats()));
    const Zones before = std::exchange(zones_, {});
    for (const SlipZone& zone : before)
      if (zone.length > least) add_zone(zones_, zone.sign, zone.length);
    return zones_.count() != before.count();
  }

  std::shared_ptr<const ZoneGrid> grid_;
  SheetKernels& kernels_;
  Zones zones_;
  std::unique_ptr<SlipContact> contact_;
  Vector unknowns_, rest_;
  Eigen::PartialPivLU<Eigen::MatrixXd> eliminated_;
};

/// The sign with which the contact slips at a sample by its inequalities; 0 where it sticks. What violates them by less than what
/// a zone of the least length would, e^-nats of the contact's, whose tractions are as the root of that, is left as it is.
int corrected_sign(const SlipField& field, const SlipField::Sample& sample) {
  const SlipContact& contact = field.contact();
  const Float least = exp(Float(-contact.grid().nats() / 2)) * field.length();
  const int sign = contact.panels()[sample.panel].sign;
  if (sign != 0) return sign * sample.slip > least ? 0 : sign;
  const auto& [pressure, shear] = sample.tractions;
  const Float most = contact.problem().friction * (pressure + least);
  return shear > most ? 1 : shear < -most ? -1 : 0;
}

/// Zones by the inequalities.
Zones corrected(const SlipField& field) {
  const SlipContact& contact = field.contact();
  Zones zones;
  Float from = 0;
  int last = 0;
  const SlipField::Sample* before = nullptr;
  for (const SlipField::Sample& sample : field.samples()) {
    const int sign = corrected_sign(field, sample);
    if (before != nullptr && sign != last) {
      const auto& panel = contact.panels()[sample.panel];
      const bool is_old = before->panel != sample.panel;
      const Float to = is_old ? panel.left : Float((before->e + sample.e) / 2);
      add_zone(zones, last, to - from);
      from = to;
    }
    last = sign;
    before = &sample;
  }
  const Float rest = field.length() - from;
  const bool turns_around =
      last == 0 && zones.count() > 0 && contact.zones()[contact.zones().count() - 1].sign != 0;
  add_zone(zones, last, turns_around ? Float(2 * rest / 3) : rest);
  // Where the slip at the trailing end is wrong up to the end it turns around, for there no sheet sticks.
  if (turns_around) zones.push_back({-contact.zones()[contact.zones().count() - 1].sign, rest / 3});
  return zones;
}

bool are_alike(const Zones& a, const Zones& b) {
  return std::ranges::equal(a, b, {}, &SlipZone::sign, &SlipZone::sign);
}

/// Solved with errors of about 10^-digits, from the field `near`, if any; the zones are left as they were found.
std::unique_ptr<const SlipField> solved(const SlipProblem& problem, SheetKernels& kernels, Zones& zones,
                                        int digits, const SlipField* near) {
  std::unique_ptr<const SlipField> field;
  for (int correction = 0; correction < most_corrections; ++correction) {
    double longest = 0;
    for (const SlipZone& zone : zones)
      longest = std::max(longest, std::min(longest_panel, static_cast<double>(zone.length)));
    Newton newton(std::make_shared<ZoneGrid>(problem, digits * std::numbers::ln10, longest), kernels, zones);
    newton.begin(field != nullptr ? field.get() : near);
    const bool converges = newton.converges();
    if (!converges && are_alike(newton.zones(), zones)) return nullptr;
    zones = newton.zones();
    if (!converges) continue;
    field = std::make_unique<SlipField>(newton.result());
    Zones better = corrected(*field);
    if (are_alike(better, zones)) return field;
    zones = std::move(better);
  }
  return nullptr;
}

}  // namespace

SolvedSlip solved_slip(const SlipProblem& problem, SheetKernels& kernels, Row<SlipZone> zones, int digits) {
  SolvedSlip result;
  for (int goal : {first_digits, digits + coarse_guard, digits + fine_guard}) {
    result.coarse = std::move(result.fine);
    result.fine = solved(problem, kernels, zones, goal, result.coarse.get());
    if (!result.fine) return {};
  }
  return result;
}

int kernel_digits_of_slip(int digits) { return digits + 2 * fine_guard; }

/// Remainders next to a panel's end are known to as many digits as they are small: twice.
int working_digits_of_slip(int digits) { return 2 * (digits + fine_guard) + 16; }

}  // namespace nipref::ref
