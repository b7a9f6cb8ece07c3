#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/inner_field.hpp>
#include <nipref/fast/nip/internal/shear_search.hpp>
#include <nipref/fast/number/internal/checks.hpp>
#include <nipref/fast/sheet/internal/half_planes.hpp>

namespace nipref::fast {
namespace {

using internal::DisplacementsFromFace;
using internal::StressesAtDepth;

/// The kernel of the numbers that `field` has at alpha under each load. Without shear both parts of g are pressure.
template <int count, class Field>
Tractions::Kernel kernel_of(const Field& field, bool sticks, const auto& numbers_of) {
  Tractions::Kernel kernel;
  kernel.functionals = count;
  kernel.at = [field, sticks, numbers_of](std::span<const double> alpha, Eigen::MatrixXd& on_p,
                                          Eigen::MatrixXd& on_q) {
    on_p.resize(count, static_cast<Eigen::Index>(alpha.size()));
    on_q.resizeLike(on_p);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const auto [normal, shear] = field.at(alpha[i], sticks);
      on_p.col(column) = numbers_of(normal);
      on_q.col(column) = numbers_of(sticks ? shear : normal);
    }
  };
  return kernel;
}

std::vector<Functional> functionals_of(const Solution& solution, const ContactPlace& place,
                                       const Tractions::Kernel& kernel, double tolerance, double size) {
  const Eigen::MatrixXd rows = solution.tractions().rows(place.e, place.trailing, kernel, tolerance);
  std::vector<Functional> result;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    result.push_back(solution.of_tractions(rows.row(i)));
    result.back().cancelled = size * solution.traction_bound();
  }
  return result;
}

/// A bound for the integral of the magnitude of a kernel of internal::FromFace over a contact. At any depth and any
/// Poisson's ratio a kernel is at most (1 + ln(1/a))/pi at a distance a < 1, and its integral over the whole sheet is
/// at most 0.8. A test computes both from the kernels. v under shear beside the middle plane of an incompressible sheet
/// comes closest: it reaches 0.956 of the first bound, and 0.783.
double reach_of_displacements(double half_length) {
  const double a = std::min(half_length, 1.0);
  return std::min(0.8, 2 / std::numbers::pi * a * (2 - std::log(a)));
}
/// A bound for the integral of the magnitude of a stress kernel over the contact. Under pressure it is at most 2.01, that
/// of the stress along the sheet next to a face: 1 of the half-plane below it and 1.004 of the rest. Under shear that
/// stress falls like 2/(pi alpha) beyond the `distance` from the loads, and the integral is at most (2/pi) ln(1 +
/// (2A/distance)^2), A the half-length, for A <= 1. Farther than 1 the kernel tends to 1/2, half of each load's pull. Its
/// integral is the mean tension of the sheet, which is not larger than the pressure; as much again covers it. A test
/// computes both bounds from the kernels.
double size_of_stresses(double half_length, double distance, bool sticks) {
  const double logarithm = sticks ? std::log1p(std::pow(2 * half_length / distance, 2)) : 0;
  return 2.01 + 4 * std::numbers::inv_pi * logarithm;
}

Estimate mean_of(const InnerStresses& s) {
  return {(s.across.value + s.along.value) / 2, (s.across.error + s.along.error) / 2};
}

}  // namespace

Estimate InnerStresses::maximum_shear() const {
  // The radius is the distance of two points: it changes by no more than the points move.
  return {std::hypot((across.value - along.value) / 2, shear.value),
          std::hypot((across.error + along.error) / 2, shear.error)};
}

Estimate InnerStresses::highest() const {
  const Estimate mean = mean_of(*this), radius = maximum_shear();
  return {mean.value + radius.value, mean.error + radius.error};
}

Estimate InnerStresses::lowest() const {
  const Estimate mean = mean_of(*this), radius = maximum_shear();
  return {mean.value - radius.value, mean.error + radius.error};
}

Tractions::Kernel InnerField::stress_kernel(double depth) const {
  const bool on_face = std::fabs(depth) == 1, sticks = equations_.sticks();
  Tractions::Kernel kernel = kernel_of<3>(StressesAtDepth(depth), sticks, [](const SheetStresses& s) {
    return Eigen::Vector3d(s.across, s.along, s.shear);
  });
  // Far away a shear load pulls one half of the sheet and presses on the other.
  using enum Tractions::Kernel::FarAway;
  kernel.beyond_reach = sticks ? linear : negligible;
  // On a face the kernel of the pressure has only the poles of the load on the other face.
  kernel.poles = on_face && !sticks ? 2 : 1 - std::fabs(depth);
  kernel.is_regular = !on_face || !sticks;
  return kernel;
}

std::vector<Functional> InnerField::stresses(const Solution& solution, const ContactPlace& where,
                                             double depth, const Tractions::Kernel& kernel,
                                             double tolerance) const {
  const ContactPlace place = where.from_nearer_end_of(solution);
  const auto acting = [&] {
    const double distance = std::hypot(1 - std::fabs(depth), std::max(-place.e, 0.0));
    return functionals_of(solution, place, kernel, tolerance,
                          size_of_stresses(solution.half_length(), distance, equations_.sticks()));
  };
  if (std::fabs(depth) < 1) return acting();
  const Functional pressure = equations_.traction(solution, TractionComponent::pressure, place);
  if (!equations_.sticks()) return {-1 * pressure, acting()[1] - pressure, 0 * pressure};
  if (place.e < 0) return {-1 * pressure, acting()[1], 0 * pressure};
  CountedKernels kernels = nip_.kernels();
  const auto [theta1, theta2] = *equations_.shares();
  return {-1 * pressure, 2 * equations_.creep_ratio(solution, kernels) - (theta1 - theta2) * pressure,
          depth * equations_.traction(solution, TractionComponent::shear, place)};
}

std::vector<Estimate> InnerField::estimates(const ContactPlace& place,
                                            const SolvedNip::AtPlace& numbers) const {
  // If the ends are given, a place has only its rounding error, 2^-52 of its distance from the end. The field is smooth
  // on the scale of that distance, so that this error is part of the rounding of the kernels.
  const double reach = ends_ == 0 ? 0 : SolvedNip::reach(place, ends_);
  std::vector<SolvedNip::InBoth> all = nip_.at_place(place, reach, numbers);
  // Next to an end the stresses are the square root of the distance from it times functions of the direction. Some of
  // these are 0 along the face, so that the shifts of the other stresses have to show how much they may change.
  if (std::fabs(place.e) <= reach) {
    const double largest = std::ranges::max(all, {}, &SolvedNip::InBoth::shift).shift;
    for (SolvedNip::InBoth& number : all) number.shift = largest;
  }
  std::vector<Estimate> result;
  for (const SolvedNip::InBoth& number : all) result.push_back(nip_.estimate(number));
  return result;
}

InnerStresses InnerField::at(const SheetPoint& point) const {
  const Tractions::Kernel kernel = stress_kernel(point.depth);
  const auto all = estimates(point.place, [&](const Solution& solution, const ContactPlace& place) {
    return stresses(solution, place, point.depth, kernel, quadrature_tolerance);
  });
  const bool has_shear = point.depth != 0 && !point.is_middle;
  return {all[0], all[1], has_shear ? all[2] : Estimate{0, 0}};
}

InnerDisplacements InnerField::from_face(const SheetPoint& point, const internal::Shares& share) const {
  // A kernel is the sum of some eight parts of its size with eight roundings each. 16 roundings are counted already.
  constexpr double roundings = 64.0 / 16;
  const double depth = std::fabs(point.depth);
  if (depth == 1) return {{0, 0}, {0, 0}};
  Tractions::Kernel kernel =
      kernel_of<2>(DisplacementsFromFace(depth, share), equations_.sticks(),
                   [](const internal::FromFace& f) { return Eigen::Vector2d(-f.u, f.v); });
  kernel.poles = 1 - depth;
  const auto all = estimates(point.place, [&](const Solution& solution, const ContactPlace& place) {
    return functionals_of(solution, place.from_nearer_end_of(solution), kernel, quadrature_tolerance,
                          roundings * reach_of_displacements(solution.half_length()));
  });
  return {depth == 0 ? Estimate{0, 0} : all[0], point.is_middle ? Estimate{0, 0} : all[1]};
}

GreatestShear InnerField::greatest_shear() const {
  using Point = ShearSearch::Point;
  const double half_length = nip_.half_length();
  const bool is_symmetric = nip_.is_symmetric();
  const auto place_of = [&](double y) { return ContactPlace{y < 0, half_length - std::fabs(y)}; };
  const ShearSearch search(half_length, is_symmetric, [&](const Point& point, double tolerance) {
    const Solution& last = nip_.last();
    const auto s = stresses(last, place_of(point.y), point.depth, stress_kernel(point.depth), tolerance);
    return std::hypot((last.value(s[0]) - last.value(s[1])) / 2, last.value(s[2]));
  });
  struct Top {
    Point at;
    Estimate shear;
  };
  std::vector<Top> tops;
  for (const Point& top : search.maxima())
    tops.push_back({top, at({place_of(top.y), top.depth, is_symmetric && top.y == 0}).maximum_shear()});
  const Top& best = *std::ranges::max_element(tops, {}, [](const Top& top) { return top.shear.value; });
  GreatestShear result{best.shear, {best.at.y, 0}, {best.at.depth, 0}};
  for (const auto& [at, shear] : tops) {
    const double slack = best.shear.error + shear.error, lower = best.shear.value - shear.value;
    if (lower > slack) continue;
    const Point around = search.flat_part(at, slack);
    result.value.error = std::max(result.value.error, shear.error - lower);
    result.y.error = std::max(result.y.error, std::fabs(at.y - best.at.y) + around.y);
    const double away = std::fabs(at.depth - best.at.depth);
    result.depth.error = std::max(result.depth.error, std::min(away + around.depth, 1.0));
  }
  return result;
}

void check_inside(const InnerPoint& point) {
  internal::check_finite("y", point.y);
  if (!(std::fabs(point.depth) <= 1))
    throw data::BadInput("depth", point.depth, "must satisfy -1 <= depth <= 1");
}

InnerDisplacements beyond_face(const InnerDisplacements& face, double depth, double unit,
                               const InnerDisplacements& beyond) {
  const auto sum = [&](double share, const Estimate& of_face, const Estimate& rest) -> Estimate {
    if (share == 0) return rest;
    if (rest.error == 0) return share * of_face;
    const Estimate more = times(unit, rest);
    const double value = share * of_face.value + more.value;
    // The product and the sum are rounded.
    return {value, share * of_face.error + more.error +
                       0x1p-53 * (std::fabs(value) + share * std::fabs(of_face.value))};
  };
  return {sum(std::fabs(depth), face.across, beyond.across), sum(1, face.along, beyond.along)};
}

}  // namespace nipref::fast
