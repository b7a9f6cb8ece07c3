#include <cmath>
#include <numbers>
#include <vector>

#include <nipref/fast/nip/internal/panels.hpp>
#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>

#include "support/test.hpp"

using namespace nipref;
using namespace nipref::fast;

namespace {

/// Poisson's kernel, with poles at +- i distance.
Tractions::Kernel poisson_kernel(double distance) {
  Tractions::Kernel kernel;
  kernel.beyond_reach = Tractions::Kernel::FarAway::varying;
  kernel.poles = distance;
  kernel.is_regular = true;
  kernel.at = [distance](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    const Eigen::Map<const Eigen::RowVectorXd> at(alpha.data(), static_cast<Eigen::Index>(alpha.size()));
    on_p = (distance * std::numbers::inv_pi / (at.array().square() + distance * distance)).matrix();
    on_q = on_p;
  };
  return kernel;
}

/// Integrals of Poisson's kernel times all columns, by Gauss's rule on pieces that halve towards place and ends.
Eigen::RowVectorXd by_pieces(const Tractions& tractions, double place, double distance) {
  const GaussRule rule = gauss_legendre(30);
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(tractions.columns());
  const auto add_piece = [&](double from, double to) {
    for (std::size_t i = 0; i < rule.at.size(); ++i) {
      const double e = from + (to - from) * rule.at[i], alpha = e - place;
      sum += (to - from) * rule.weight[i] * distance * std::numbers::inv_pi /
             (alpha * alpha + distance * distance) * tractions.values(e).row(0);
    }
  };
  const auto add = [&](double from, double to) {
    const double middle = (from + to) / 2;
    double width = middle - from;
    for (; width > 1e-12; width /= 2) {
      add_piece(from + width / 2, from + width);
      add_piece(to - width, to - width / 2);
    }
    add_piece(from, from + width);
    add_piece(to - width, to);
  };
  std::vector<double> ends{0, std::min(place, tractions.half_length())};
  for (const Panel& panel : tractions.panels())
    ends.push_back(std::min(panel.right, tractions.half_length()));
  std::ranges::sort(ends);
  for (std::size_t i = 1; i < ends.size(); ++i) add(ends[i - 1], ends[i]);
  return sum;
}

/// |alpha| + 2 e^(-2.1 |alpha|), which counts its evaluations.
Tractions::Kernel linear_far_away(Tractions::Kernel::FarAway beyond_reach, int& evaluations) {
  Tractions::Kernel kernel;
  kernel.beyond_reach = beyond_reach;
  kernel.at = [&evaluations](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    const Eigen::Map<const Eigen::RowVectorXd> at(alpha.data(), static_cast<Eigen::Index>(alpha.size()));
    on_q = on_p = (at.array().abs() + 2 * (-2.1 * at.array().abs()).exp()).matrix();
    evaluations += static_cast<int>(alpha.size());
  };
  return kernel;
}

}  // namespace

TEST_CASE("far from the place a kernel that has become linear needs few nodes") {
  using enum Tractions::Kernel::FarAway;
  const double half_length = 300;
  const Tractions tractions(half_length, panels(half_length, {34, 2.1, 5, {}}), true, 0.5);
  for (const double at : {-5.0, 0.1, 7.0, 60.0, 299.0}) {
    CAPTURE(at);
    int few = 0, many = 0;
    const Eigen::RowVectorXd row = tractions.rows(at, false, linear_far_away(linear, few), 1e-16),
                             expected = tractions.rows(at, false, linear_far_away(varying, many), 1e-16);
    CHECK((row - expected).cwiseAbs().maxCoeff() < 1e-14 * expected.cwiseAbs().maxCoeff());
    CHECK(few < 0.7 * many);
  }
}

TEST_CASE("rows are the integrals of a kernel with the tractions, however near its poles are") {
  for (const double half_length : {0.5, 4.0, 20.0}) {
    const Tractions tractions(half_length, panels(half_length, {34, 2.1, 2, {}}), false, 0.5);
    for (const double distance : {1e-3, 0.04, 0.4}) {
      for (const double part : {1e-3, 0.06, 0.5, 0.9}) {
        CAPTURE(half_length, distance, part);
        const double at = part * half_length;
        const Eigen::RowVectorXd row = tractions.rows(at, false, poisson_kernel(distance), 1e-16);
        // The other half of the contact is the mirror image.
        const Eigen::RowVectorXd expected =
            by_pieces(tractions, at, distance) + by_pieces(tractions, 2 * half_length - at, distance);
        CHECK((row - expected).cwiseAbs().maxCoeff() < 2e-14);
      }
    }
  }
}
