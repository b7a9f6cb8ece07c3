#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/nip/internal/inner_field.hpp>
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

/// A point of the search for the largest shear, y from the contact's middle.
struct SearchPoint {
  double y, depth;
};
constexpr int grid_steps = 24;
/// The local maxima on the grid on which the search begins, as deep as 2.5 half-lengths. It is denser at the ends,
/// beside which full friction may cause the largest shear.
std::vector<SearchPoint> grid_maxima(double half_length, bool is_symmetric, const auto& shear_at) {
  const double deepest = std::min(1.0, 2.5 * half_length);
  const int first = is_symmetric ? 0 : -grid_steps, columns = grid_steps - first + 1;
  const auto point = [&](Eigen::Index i, Eigen::Index j) -> SearchPoint {
    const double along = static_cast<double>(first + i) / grid_steps;
    return {half_length * std::sin(std::numbers::pi / 2 * along),
            1 - deepest * static_cast<double>(j) / grid_steps};
  };
  const Eigen::MatrixXd shears = Eigen::MatrixXd::NullaryExpr(
      columns, grid_steps + 1, [&](Eigen::Index i, Eigen::Index j) { return shear_at(point(i, j)); });
  std::vector<SearchPoint> maxima;
  for (Eigen::Index i = 0; i < shears.rows(); ++i) {
    for (Eigen::Index j = 0; j < shears.cols(); ++j) {
      const Eigen::Index left = std::max<Eigen::Index>(i - 1, 0), above = std::max<Eigen::Index>(j - 1, 0);
      const auto around = shears.block(left, above, std::min(i + 2, shears.rows()) - left,
                                       std::min(j + 2, shears.cols()) - above);
      if (shears(i, j) == around.maxCoeff()) maxima.push_back(point(i, j));
    }
  }
  return maxima;
}

/// The distances from a maximum within which a function falls by no more than `slack`, from `least` to `most`;
/// fall(y, depth) is its fall at distances in both directions. Beside the maximum, a paraboloid falls by f_y or f_d at
/// a distance in one direction, and by f_y + f_d +- 2 c (f_y f_d)^(1/2) at both distances. What of it is above a level
/// reaches 1/(1 - c^2)^(1/2) times as far in a direction as it does on this direction's axis.
SearchPoint flat_part(const auto& fall, double slack, double least, const SearchPoint& most) {
  const auto on_axis = [&](double y, double depth, double farthest) {
    double far = least;
    while (far < farthest && !(std::min(fall(far * y, far * depth), fall(-far * y, -far * depth)) > slack))
      far *= 1.5;
    return std::min(far, farthest);
  };
  const double y = on_axis(1, 0, most.y), depth = on_axis(0, 1, most.depth);
  double c = 0;
  for (const double to_y : {y, -y}) {
    for (const double to_depth : {depth, -depth}) {
      const double along = fall(to_y, 0), across = fall(0, to_depth), both = fall(to_y, to_depth);
      if (std::isinf(both)) continue;
      const double product = along * across;
      if (product > 0)
        c = std::max(c, std::fabs(both - along - across) / (2 * std::sqrt(product)));
      else if (!(both > slack))
        c = 1;
    }
  }
  const double longer = 1 / std::sqrt(std::max(1 - c * c, 0.0));
  return {std::min(longer * y, most.y), std::min(longer * depth, most.depth)};
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
  kernel.beyond_reach = sticks ? constant : negligible;
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
  const double half_length = nip_.half_length(), reach = std::min(1.0, half_length);
  const bool is_symmetric = nip_.is_symmetric();
  constexpr double coarse = 1e-5;
  double tolerance = coarse;
  const auto place_of = [&](double y) { return ContactPlace{y < 0, half_length - std::fabs(y)}; };
  const auto shear_at = [&](const SearchPoint& at) {
    const Solution& last = nip_.last();
    const auto s = stresses(last, place_of(at.y), at.depth, stress_kernel(at.depth), tolerance);
    return std::hypot((last.value(s[0]) - last.value(s[1])) / 2, last.value(s[2]));
  };
  const auto from_end = [&](const SearchPoint& at) {
    return std::hypot(half_length - std::fabs(at.y), 1 - at.depth);
  };
  const auto scale = [&](const SearchPoint& at) { return std::min(reach, from_end(at)); };
  const auto last_step = [&](const SearchPoint& at) { return std::max(1e-9 * scale(at), 1e-14 * reach); };
  const auto top_near = [&](SearchPoint best) {
    double largest = 0;
    const auto moves_to = [&](const SearchPoint& point) {
      const double here = shear_at(point);
      if (!(here > largest)) return false;
      largest = here;
      best = point;
      return true;
    };
    // A step changes the shear by about (step/scale)^2. A tolerance of this part of the change shows its sign.
    const auto resolve = [&](double step) {
      constexpr double telling = 1e-4;
      tolerance = std::clamp(telling * std::pow(step / scale(best), 2), quadrature_tolerance, coarse);
      largest = shear_at(best);
    };
    double step = reach / grid_steps;
    resolve(step);
    while (step > last_step(best)) {
      const auto [y, depth] = best;
      const double back = is_symmetric ? std::fabs(y - step) : y - step;
      const bool moved = moves_to({y + step, depth}) || moves_to({back, depth}) ||
                         moves_to({y, std::min(1.0, depth + step)}) || moves_to({y, std::fabs(depth - step)});
      if (moved) continue;
      step /= 2;
      resolve(step);
    }
    return best;
  };
  struct Top {
    SearchPoint at;
    Estimate shear;
  };
  std::vector<Top> tops;
  for (const SearchPoint& start : grid_maxima(half_length, is_symmetric, shear_at)) {
    const SearchPoint best = top_near(start);
    tops.push_back({best, at({place_of(best.y), best.depth, is_symmetric && best.y == 0}).maximum_shear()});
  }
  tolerance = quadrature_tolerance;
  const Top& best = *std::ranges::max_element(tops, {}, [](const Top& top) { return top.shear.value; });
  GreatestShear result{best.shear, {best.at.y, 0}, {best.at.depth, 0}};
  for (const auto& [at, shear] : tops) {
    const double slack = best.shear.error + shear.error, lower = best.shear.value - shear.value;
    if (lower > slack) continue;
    const auto fall = [&, &top = at, highest = shear_at(at)](double y, double depth) {
      const SearchPoint there{top.y + y, top.depth + depth};
      const bool is_sought = there.depth >= 0 && there.depth <= 1 && !(is_symmetric && there.y < 0);
      return is_sought ? highest - shear_at(there) : std::numeric_limits<double>::infinity();
    };
    const SearchPoint around = flat_part(fall, slack, last_step(at), {2 * half_length, 1});
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
