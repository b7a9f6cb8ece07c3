#include <boost/math/tools/roots.hpp>
#include <functional>

#include <nipref/verify/seeds/internal/thesis_nip.hpp>

namespace nipref::verify {

double sign_change(const std::function<double(double)>& function, double lower, double upper) {
  constexpr int binary_digits = 34;
  std::uintmax_t steps = 100;
  const auto ends = boost::math::tools::toms748_solve(
      function, lower, upper, boost::math::tools::eps_tolerance<double>(binary_digits), steps);
  return (ends.first + ends.second) / 2;
}

}  // namespace nipref::verify
