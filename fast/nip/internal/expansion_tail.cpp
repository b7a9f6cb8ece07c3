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

std::vector<double> expansion_tails(const SolutionAndTwins& found, Eigen::Index terms,
                                    Eigen::Index expansions) {
  std::vector<double> tails;
  for (Eigen::Index i = 0; i < expansions; ++i) {
    const Eigen::VectorXd coefficients = found.solution.segment(i * terms, terms);
    const double tail = last_coefficients(coefficients);
    double squares = 0;
    for (const auto& twin : found.twins.colwise())
      squares += std::pow(last_coefficients(twin.segment(i * terms, terms) - coefficients), 2);
    const double lost = 12 * std::sqrt(squares / static_cast<double>(found.twins.cols()));
    tails.push_back(tail > lost ? tail : 0);
  }
  return tails;
}

}  // namespace nipref::fast
