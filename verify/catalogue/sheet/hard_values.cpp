#include <nipref/fast/sheet/branch_points.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using Limits = std::numeric_limits<double>;

/// The value and its neighbouring doubles, with alternating signs, so that both signs occur without twice as many points.
void add_with_neighbours(std::vector<double>& values, double value) {
  for (const double near : {std::nextafter(value, 0.0), value, std::nextafter(value, Limits::infinity())})
    values.push_back(values.size() % 2 == 0 ? near : -near);
}

/// fast's branch points, and the ends of the range of doubles and of the kernels: e^(-2.106 x) becomes subnormal at 336 and
/// vanishes at 354.
std::vector<double> hard_positions() {
  std::vector<double> values;
  for (const double branch : fast::branch_points()) add_with_neighbours(values, branch);
  for (const double extreme : {2 * Limits::denorm_min(), Limits::min(), 1e-300, 1e-160, 1e-16, 1e-8, 0.5, 1.0,
                               336.0, 345.0, 353.0, 354.0, 355.0, 400.0, 700.0}) {
    add_with_neighbours(values, extreme);
  }
  return values;
}

}  // namespace

std::vector<double> hard_values(ArgumentKind kind) {
  std::vector<double> values;
  switch (kind) {
    case ArgumentKind::nonzero_position:
      return hard_positions();
    case ArgumentKind::position:
      values = hard_positions();
      values.insert(values.end(), {0.0, -0.0});
      return values;
    case ArgumentKind::young:
      return {1e-6, 1.0, 145000.0, 1e12};
    case ArgumentKind::poisson:
      return {std::nextafter(-1.0, 0.0), -0.999, -0.5, 0.0, 0.25, 0.3, 1.0 / 3, 0.4999,
              std::nextafter(0.5, 0.0),  0.5};
    case ArgumentKind::index:
      return {1, 2, 3, 10, 499, 500, 501, 999'999, 1'000'000};
    default:
      return {};
  }
}

}  // namespace nipref::verify
