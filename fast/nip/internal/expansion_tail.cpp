#include <nipref/fast/nip/internal/expansion_tail.hpp>

namespace nipref::fast {
namespace {

double last_coefficients(const Eigen::VectorXd& coefficients) {
  constexpr double usual = 5;
  double largest = 0, fallen = 1;
  for (Eigen::Index k = coefficients.size() - 1; k >= 0 && k > coefficients.size() - 4; --k, fallen *= usual)
    largest = std::max(largest, std::fabs(coefficients(k)) / fallen);
  return largest;
}

}  // namespace

double expansion_tail(const SolutionAndTwins& found, Eigen::Index terms, Eigen::Index expansions) {
  double largest = 0;
  for (Eigen::Index i = 0; i < expansions; ++i) {
    const Eigen::VectorXd coefficients = found.solution.segment(i * terms, terms);
    const double tail = last_coefficients(coefficients);
    double squares = 0;
    for (const auto& twin : found.twins.colwise())
      squares += std::pow(last_coefficients(twin.segment(i * terms, terms) - coefficients), 2);
    const double lost = 12 * std::sqrt(squares / static_cast<double>(found.twins.cols()));
    if (tail > lost) largest = std::max(largest, tail);
  }
  return largest;
}

}  // namespace nipref::fast
