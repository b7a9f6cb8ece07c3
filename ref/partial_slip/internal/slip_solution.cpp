#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

using Zones = Row<SlipZone>;

constexpr int most_newton_steps = 40, most_corrections = 8;
/// Digits of the grid on which zones are first sought, which is refined once, and extra digits of the last two grids.
constexpr int first_digits = 6, coarse_guard = 3, fine_guard = 5;
/// Relative change of a zone's length in a difference quotient, whose full precision leaves it more digits than a
/// double.
constexpr double step_of_lengths = 0x1p-50;
/// Largest change of the logarithm of a zone's length in a step of Newton's method.
constexpr double most_change = 0.7;
/// The slopes are renewed if a step does not reduce the residual by this factor.
constexpr double slow_convergence = 0.01;

Eigen::VectorXd in_double(const Vector& x, const Float& unit) {
  Eigen::VectorXd result(x.size());
  for (GridIndex i = 0; i < x.size(); ++i) result(i) = static_cast<double>(Float(x(i) / unit));
  return result;
}

/// The zones without those shorter than e^-nats of the contact, except for stick between opposite slips.
Zones without_short(const Zones& zones, double nats) {
  Float least = 0;
  for (const SlipZone& zone : zones) least += zone.length * exp(Float(-nats));
  Zones rest;
  for (GridIndex i = 0; i < zones.count(); ++i) {
    const bool turns = 0 < i && i + 1 < zones.count() && zones[i - 1].sign * zones[i + 1].sign < 0;
    if (turns || zones[i].length > least) add_zone(rest, zones[i].sign, zones[i].length);
  }
  return rest;
}

bool are_alike(const Zones& a, const Zones& b) {
  return std::ranges::equal(a, b, {}, &SlipZone::sign, &SlipZone::sign);
}

/// Newton's method for the unknowns and the logarithms of the zones' lengths together.
class Newton {
 public:
  Newton(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels, const Zones& zones)
      : grid_(std::move(grid)), kernels_(kernels), zones_(zones) {
    renew();
    unknowns_ = Vector(contact_->sizes().count());
  }

  /// Begins with the tractions of `near` or, without it, with those of least squares.
  void begin(const SlipField* near) {
    if (near != nullptr) {
      unknowns_ = contact_->unknowns_of(*near);
    } else {
      evaluate();
      change_unknowns(contact_->slopes().colPivHouseholderQr().solve(in_double(rest_, 1)), 1);
    }
    evaluate();
  }

  /// Returns whether the method converges. If a zone vanishes, it does not, and zones() are without that zone.
  bool converges() {
    if (rest_.size() != unknowns_.size() + zones_.count()) return false;
    const Float enough = exp(Float(-grid_->nats())) / 100 * grid_->problem().unit;
    bool is_new = true;
    for (int step = 0; step < most_newton_steps; ++step) {
      const Float size = largest_entry(rest_);
      if (size < enough) return true;
      if (is_new) make_slopes();
      const Eigen::VectorXd change = newton_step(in_double(rest_, size));
      if (!change.allFinite()) return false;
      const double most = change.tail(zones_.count()).cwiseAbs().maxCoeff() * static_cast<double>(size);
      const Float part = size * std::min(1.0, most_change / most);
      change_unknowns(change, part);
      for (GridIndex i = 0; i < zones_.count(); ++i)
        zones_[i].length *= exp(Float(-part * change(unknowns_.size() + i)));
      const Zones before = std::exchange(zones_, without_short(zones_, grid_->nats()));
      if (!are_alike(before, zones_)) return false;
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
    slopes_.resize(rest_.size(), rest_.size());
    slopes_.leftCols(linear) = contact_->slopes();
    for (GridIndex i = 0; i < zones_.count(); ++i) {
      Zones longer = zones_;
      longer[i].length *= 1 + step_of_lengths;
      SlipContact changed(grid_, kernels_, longer);
      changed.set(unknowns_);
      slopes_.col(linear + i) = in_double(changed.residual() - rest_, step_of_lengths);
    }
    eliminated_.compute(slopes_);
  }

  /// A step is refined once, so that the rounding error of each equation is relative to its own terms (Skeel 1980):
  /// rows of zones as short as 1e-12 of the contact are small differences of the others.
  [[nodiscard]] Eigen::VectorXd newton_step(const Eigen::VectorXd& rest) const {
    const Eigen::VectorXd first = eliminated_.solve(rest);
    return first + eliminated_.solve(rest - slopes_ * first);
  }

  std::shared_ptr<const ZoneGrid> grid_;
  SheetKernels& kernels_;
  Zones zones_;
  std::unique_ptr<SlipContact> contact_;
  Vector unknowns_, rest_;
  Eigen::MatrixXd slopes_;
  Eigen::PartialPivLU<Eigen::MatrixXd> eliminated_;
};

/// The sign that a sample should have by the inequalities, 0 for stick, and by how much these are violated.
std::pair<int, Float> sign_by_inequality(const SlipField::Sample& sample, double friction) {
  const auto& [pressure, shear] = sample.tractions;
  const Float excess =
      sample.sign == 0 ? Float(abs(shear) / friction - pressure) : Float(sample.sign * sample.slip);
  if (excess <= 0) return {sample.sign, 0};
  return {sample.sign != 0 ? 0 : shear > 0 ? 1 : -1, excess};
}

/// The zones by the inequalities, nothing if these hold. A stretch where they are violated changes its sign, unless it
/// or the violation is smaller than that of the shortest zone, which is e^-nats of the contact: tractions are like the
/// root of a length. Where the stretch joins its neighbours, signs are as before, and only the lengths differ.
std::optional<Zones> corrected(const SlipField& field) {
  const SlipContact& contact = field.contact();
  const double nats = contact.grid().nats(), friction = contact.problem().friction;
  const Float least = exp(Float(-nats / 2)) * field.length(), shortest = exp(Float(-nats)) * field.length();
  const auto& samples = field.samples();
  Zones zones;
  bool is_violated = false;
  Float from = 0;
  for (GridIndex i = 0; i < samples.count();) {
    const int old = samples[i].sign, sign = sign_by_inequality(samples[i], friction).first;
    Float most = 0, to = field.length();
    for (; i < samples.count(); ++i) {
      const auto [here, violation] = sign_by_inequality(samples[i], friction);
      if (here != sign || samples[i].sign != old) {
        const bool is_joint = samples[i - 1].panel != samples[i].panel;
        to =
            is_joint ? contact.panels()[samples[i].panel].left : Float((samples[i - 1].e + samples[i].e) / 2);
        break;
      }
      most = std::max(most, violation);
    }
    const bool changes = most > least && to - from > shortest;
    add_zone(zones, changes ? sign : old, to - from);
    is_violated |= changes;
    from = to;
  }
  return is_violated ? std::optional(without_short(zones, nats)) : std::nullopt;
}

/// At the trailing end no sheet sticks, unless it sticks all along. Slip there that violates its inequality changes its
/// sign. If it vanishes, the slip before it is extended to the end; if there is none, slip of the other sign is added.
void slip_at_end(Zones& zones, const Zones& before, const SlipProblem& problem, bool vanishes) {
  const auto& [sign, length] = before.back();
  if (zones.back().sign != 0 || sign == 0 || problem.may_stick_all_along(zones)) return;
  if (vanishes && zones.count() > 1) {
    zones[zones.count() - 2].length += zones.back().length;
    zones.pop_back();
    return;
  }
  const Float part = std::min(length, zones.back().length) / 3;
  zones.back().length -= part;
  zones.push_back({-sign, part});
}

/// Solves with errors of about 10^-digits, from the field `near` if there is one. `zones` become those that are found.
std::unique_ptr<const SlipField> solved(const SlipProblem& problem, SheetKernels& kernels, Zones& zones,
                                        int digits, const SlipField* near) {
  std::unique_ptr<const SlipField> field;
  for (int correction = 0; correction < most_corrections; ++correction) {
    Newton newton(std::make_shared<ZoneGrid>(problem, digits * std::numbers::ln10, zones), kernels, zones);
    newton.begin(field != nullptr ? field.get() : near);
    const bool converges = newton.converges();
    if (converges) field = std::make_unique<SlipField>(newton.result());
    std::optional<Zones> better = converges ? corrected(*field) : newton.zones();
    if (!better) {
      zones = newton.zones();
      return field;
    }
    slip_at_end(*better, zones, problem, !converges);
    if (!converges && are_alike(*better, zones)) return nullptr;
    zones = *std::move(better);
  }
  return nullptr;
}

}  // namespace

SolvedSlip solved_slip(const SlipProblem& problem, SheetKernels& kernels, Row<SlipZone> zones, int digits) {
  SolvedSlip result{std::make_unique<SheetKernels>(digits + coarse_guard + fine_guard), nullptr, nullptr};
  for (int goal : {first_digits, 2 * first_digits, digits + coarse_guard, digits + fine_guard}) {
    auto field = solved(problem, goal == digits + coarse_guard ? *result.coarse_kernels : kernels, zones,
                        goal, result.fine.get());
    // Short zones may be visible on a finer grid only.
    if (!field && goal == first_digits) continue;
    if (!field) return {};
    result.coarse = std::exchange(result.fine, std::move(field));
  }
  return result;
}

/// With the two digits by which the coarser solution has fewer, a kernel's interpolation has a node more.
int kernel_digits_of_slip(int digits) { return digits + 2 * fine_guard; }

/// Remainders near a panel's end are small by as many digits as are wanted of them, which makes twice the digits.
/// Differences over the lengths of zones that are as short lose as many again.
int working_digits_of_slip(int digits) { return 3 * (digits + fine_guard) + 10; }

}  // namespace nipref::ref
