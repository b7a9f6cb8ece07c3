#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/contact_field.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/number/internal/checks.hpp>

namespace nipref::fast {
namespace {

/// On the leading half with e from its end, or on the other. Without symmetry g is the even and the odd part of the
/// pressure.
FaceTraction face_traction(const SolvedNip& nip, bool is_symmetric, bool right, double e) {
  const std::complex<double> g = nip.traction(e);
  if (is_symmetric) return {g.real(), right ? g.imag() : -g.imag()};
  return {right ? g.real() + g.imag() : g.real() - g.imag(), 0};
}

/// The largest pressure, and the largest errors of both components of the tractions together, at some places of each panel.
std::pair<double, double> peak_and_error(const SolvedNip& nip) {
  double peak = 0, error = 0;
  const Solution& solution = nip.last();
  for (const Panel& panel : solution.tractions().panels()) {
    for (const double part : {0.02, 0.2, 0.47, 0.96}) {
      const double e = std::min(panel.left + part * panel.width(), solution.half_length());
      const auto component = [e](int row) {
        return [e, row](const Solution& s) {
          return s.of_tractions(s.tractions().values(std::min(e, s.half_length())).row(row));
        };
      };
      const Estimate real = nip.estimate(component(0));
      peak = std::max(peak, std::fabs(real.value));
      double both = real.error;
      if (solution.tractions().components() == 2) both += nip.estimate(component(1)).error;
      error = std::max(error, both);
    }
  }
  return {peak, error};
}

/// A bound for the integral of the magnitude of a kernel of internal::FromFace over a contact: at any depth and any Poisson's
/// ratio a kernel is at most (1 + ln(1/a))/pi at a distance a < 1, and its integral over the whole sheet at most 0.8. Both
/// are properties of the kernels alone, which a test computes: 0.956 of the first and 0.783 are reached by v under shear
/// beside the middle plane of an incompressible sheet.
double reach_of_displacements(double half_length) {
  const double a = std::min(half_length, 1.0);
  return std::min(0.8, 2 / std::numbers::pi * a * (2 - std::log(a)));
}
/// A kernel is the sum of some eight parts of its size, each with eight roundings.
constexpr double rounding_of_displacements = 64 * 0x1p-53;

}  // namespace

ContactField::ContactField(const SolvedNip& nip, bool is_symmetric, double middle, double ends)
    : is_symmetric_(is_symmetric),
      middle_(middle),
      half_length_(nip.half_length()),
      ends_(ends),
      field_(half_length_, is_symmetric,
             [&](bool right, double e) { return face_traction(nip, is_symmetric, right, e); }) {
  std::tie(peak_, traction_error_) = peak_and_error(nip);
  traction_error_ += field_.unresolved();
}

double ContactField::error_at(const SheetPoint& place) const {
  const double beside = std::fabs(std::fabs(place.alpha) - half_length_);
  const double outside = std::max(0.0, std::fabs(place.alpha) - half_length_),
               deep = 1 - std::fabs(place.depth);
  // Stresses are at most of this part of the tractions that make them: the whole load at their distance.
  const double part = std::min(1.0, half_length_ / std::hypot(outside, deep));
  const double unsure = ends_ + 4e-16 * (half_length_ + std::fabs(place.alpha));
  const double away = std::max(unsure, std::hypot(beside, deep));
  const double of_ends = peak_ * unsure * std::min(1.0, half_length_ / away) / std::sqrt(away * half_length_);
  return of_ends + part * (4 * traction_error_ + peak_ * field_.rounding());
}

std::vector<InnerStresses> ContactField::at(const std::vector<SheetPoint>& places) const {
  std::vector<InnerStresses> result;
  for (const SheetPoint& place : places) {
    const SheetPoint moved{place.alpha - middle_, place.depth};
    const auto [across, along, shear] = field_.at(moved);
    const double error = error_at(moved);
    result.push_back({{across, error}, {along, error}, {shear, error}});
  }
  return result;
}

std::vector<InnerDisplacements> ContactField::from_face(const std::vector<SheetPoint>& places,
                                                        const internal::Shares& share) const {
  std::vector<InnerDisplacements> result;
  for (const SheetPoint& place : places) {
    if (std::fabs(place.depth) == 1) {
      result.push_back({{0, 0}, {0, 0}});
      continue;
    }
    const SheetPoint moved{place.alpha - middle_, place.depth};
    const auto [u, v] = field_.from_face(moved, share);
    const double unsure = ends_ + 4e-16 * (half_length_ + std::fabs(moved.alpha));
    const double wrong = traction_error_ + rounding_of_displacements * peak_;
    const double error =
        8 * peak_ * std::min(unsure, half_length_) + reach_of_displacements(half_length_) * wrong;
    const bool is_middle = place.depth == 0;
    const bool is_odd = is_symmetric_ && place.alpha == 0;
    result.push_back(
        {is_middle ? Estimate{0, 0} : Estimate{u, error}, is_odd ? Estimate{0, 0} : Estimate{v, error}});
  }
  return result;
}

GreatestShear ContactField::greatest() const {
  const double reach = std::min(1.0, half_length_);
  const auto shear_at = [&](const SheetPoint& place) {
    const SheetStresses s = field_.at(place);
    return std::hypot((s.across - s.along) / 2, s.shear);
  };
  SheetPoint best{0, 1};
  double largest = shear_at(best);
  const auto look = [&](const SheetPoint& place) {
    const double here = shear_at(place);
    if (!(here > largest)) return false;
    largest = here;
    best = place;
    return true;
  };
  // The grid is denser at the ends, beside which full friction may cause the largest shear.
  constexpr int steps = 24;
  for (int i = is_symmetric_ ? 0 : -steps; i <= steps; ++i) {
    const double alpha = half_length_ * std::sin(std::numbers::pi / 2 * i / steps);
    for (int j = 0; j <= steps; ++j) look({alpha, 1 - std::min(1.0, 2.5 * reach) * j / steps});
  }
  const auto smooth_about = [&](const SheetPoint& place) {
    return std::min(reach, std::hypot(half_length_ - std::fabs(place.alpha), 1 - place.depth));
  };
  double step = reach / steps;
  while (step > 1e-9 * smooth_about(best) && step > 1e-14 * reach) {
    const double back = best.alpha - step;
    const bool moved = look({best.alpha + step, best.depth}) ||
                       look({is_symmetric_ ? std::fabs(back) : back, best.depth}) ||
                       look({best.alpha, std::min(1.0, best.depth + step)}) ||
                       look({best.alpha, std::fabs(best.depth - step)});
    if (!moved) step /= 2;
  }
  const SheetPoint place{best.alpha + middle_, best.depth};
  const Estimate value = at({place}).front().maximum_shear();
  // About its maximum the shear is a parabola on the scale of the contact or of the sheet.
  const double unsure = smooth_about(best) * (1e-7 + 4 * std::sqrt(value.error / value.value));
  return {value, {place.alpha, unsure}, {place.depth, unsure}};
}

std::vector<SheetPoint> checked_points(std::span<const InnerPoint> points, double unit) {
  std::vector<SheetPoint> checked;
  for (const auto& [y, depth] : points) {
    internal::check_finite("y", y);
    if (!(std::fabs(depth) <= 1)) throw data::BadInput("depth", depth, "must satisfy -1 <= depth <= 1");
    checked.push_back({y / unit, depth});
  }
  return checked;
}

InnerDisplacements beyond_face(const InnerDisplacements& face, double depth, double unit,
                               const InnerDisplacements& beyond) {
  const auto sum = [&](double share, const Estimate& of_face, const Estimate& rest) -> Estimate {
    if (share == 0) return rest;
    if (rest.error == 0) return share * of_face;
    const Estimate more = times(unit, rest);
    const double value = share * of_face.value + more.value;
    return {value, share * of_face.error + more.error +
                       0x1p-53 * (std::fabs(value) + share * std::fabs(of_face.value))};
  };
  return {sum(std::fabs(depth), face.across, beyond.across), sum(1, face.along, beyond.along)};
}

}  // namespace nipref::fast
