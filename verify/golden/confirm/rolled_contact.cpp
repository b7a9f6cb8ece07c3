#include <Eigen/Dense>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <cstddef>

#include <nipref/verify/golden/confirm/rolled_contact.hpp>

namespace nipref::verify::confirm {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

RolledContact::RolledContact(const Solved& half_length, const std::function<Solved(const Solved& x)>& share,
                             const std::function<Solved(const Solved& x)>& rest, int points)
    : half_length_(half_length) {
  const Solved half_turn = pi<Solved>(), step = half_turn / points;
  // All angles are multiples of half a step; this table has cos(m step/2).
  std::vector<Solved> cosine;
  for (int m = 0; m < 4 * points; ++m) cosine.push_back(cos(Solved(step * m / 2)));
  const auto wave = [&](long j, long i) -> const Solved& {
    return cosine[static_cast<std::size_t>((j * (2 * i + 1)) % (4 * points))];
  };
  for (int i = 0; i < points; ++i) nodes_.push_back(wave(1, i));
  // The integral at node k of -ln|t - s| times the interpolant that is 1 at node i and 0 at the other nodes is the
  // sum of a function of the sum of the two angles and of the same function of their difference.
  std::vector<Solved> logarithm;
  for (int m = 0; m < 2 * points; ++m) {
    Solved sum = half_turn * log(Solved(2)) / 2;
    for (long j = 1; j < points; ++j)
      sum += half_turn / j * cosine[static_cast<std::size_t>((2 * j * m) % (4 * points))];
    logarithm.push_back(sum / points);
  }
  const Solved own_logarithm = -log(half_length_);
  using Matrix = Eigen::Matrix<Solved, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Solved, Eigen::Dynamic, 1>;
  Matrix system = Matrix::Zero(points + 2, points + 2);
  Vector right = Vector::Zero(points + 2);
  for (int k = 0; k < points; ++k) {
    for (int i = 0; i < points; ++i) {
      const Solved x = half_length_ * (nodes_[at(i)] - nodes_[at(k)]);
      const Solved of_logarithm = logarithm[at(i + k + 1)] + logarithm[at(i < k ? k - i : i - k)];
      system(k, i) = half_length_ * (share(x) * (of_logarithm + own_logarithm * step) + rest(x) * step);
    }
    // The right side is D + slope t - (A t)^2.
    system(k, points) = -half_turn;
    system(k, points + 1) = -half_turn * nodes_[at(k)];
    right(k) = -half_turn * half_length_ * half_length_ * nodes_[at(k)] * nodes_[at(k)];
  }
  for (int end = 0; end < 2; ++end) {
    for (int i = 0; i < points; ++i) {
      Solved sum = 1;
      for (long j = 1; j < points; ++j) sum += (end == 0 || j % 2 == 0 ? 2 : -2) * wave(j, i);
      system(points + end, i) = sum;
    }
  }
  const Vector found = system.partialPivLu().solve(right);
  values_.assign(found.begin(), found.end());
  const Solved slope = values_[at(points) + 1], level = values_[at(points)];
  values_.resize(at(points));
  // The same parabola is d0 - (offset + A t)^2.
  offset_ = -slope / (2 * half_length_);
  indentation_ = level + offset_ * offset_;
}

Solved RolledContact::integral(const std::function<Solved(const Solved& x)>& f) const {
  Solved sum = 0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) sum += values_[i] * f(half_length_ * nodes_[i]);
  return sum * half_length_ * pi<Solved>() / nodes_.size();
}

Solved RolledContact::load() const {
  return integral([](const Solved&) { return Solved(1); });
}

Solved RolledContact::moment() const {
  return integral([](const Solved& x) { return x; });
}

Solved RolledContact::middle_pressure() const {
  const long points = static_cast<long>(nodes_.size());
  Solved sum = 0;
  for (long i = 0; i < points; ++i) {
    Solved weight = 1;
    for (long j = 2; j < points; j += 2)
      weight += (j % 4 == 0 ? 2 : -2) * cos(pi<Solved>() * j * (2 * i + 1) / (2 * points));
    sum += weight * values_[static_cast<std::size_t>(i)];
  }
  return sum / points;
}

int smooth_points(double reach, double digits) {
  const double height = 2 / reach, ellipse = height + std::hypot(1, height);
  return 2 * static_cast<int>(8 + digits * std::log(10.0) / std::log(ellipse) / 2);
}

}  // namespace nipref::verify::confirm
