#include <limits>
#include <utility>

#include <nipref/ref/number/internal/refined_solution.hpp>

namespace nipref::ref {
namespace {

/// Each correction gains some ten digits.
constexpr int most_corrections = 60;

}  // namespace

std::optional<Vector> refined_solution(const EliminatedInDouble& approximate, const Vector& right,
                                       const std::function<Vector(const Vector&)>& apply) {
  const Vector::Index size = right.size();
  Vector x(size), rest = right;
  const Float enough = size * std::numeric_limits<Float>::epsilon() * largest_entry(right);
  for (int round = 0; round < most_corrections && largest_entry(rest) > enough; ++round) {
    const Float scale = largest_entry(rest);
    Eigen::VectorXd correction(size);
    for (Vector::Index i = 0; i < size; ++i) correction(i) = static_cast<double>(rest(i) / scale);
    correction = approximate.solve(correction);
    if (!correction.allFinite()) return {};
    Vector better = x;
    for (Vector::Index i = 0; i < size; ++i) better(i) += correction(i) * scale;
    Vector left = right - apply(better);
    if (!(largest_entry(left) < scale)) break;
    x = std::move(better);
    rest = std::move(left);
  }
  return largest_entry(rest) <= 1000 * enough ? std::optional(std::move(x)) : std::nullopt;
}

Vector refined_solution(const Matrix& matrix, const Vector& right) {
  auto solution = refined_solution(EliminatedInDouble(matrix.cast<double>()), right,
                                   [&](const Vector& x) { return matrix * x; });
  return solution ? *std::move(solution) : solve(matrix, right);
}

}  // namespace nipref::ref
