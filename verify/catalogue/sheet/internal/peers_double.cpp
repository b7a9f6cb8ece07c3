#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <boost/math/quadrature/ooura_fourier_integrals.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers.hpp>

namespace nipref::verify {
namespace {

/// sinh overflows beyond 710; from 20 on the terms dropped are below 2^-53 of those kept.
constexpr double asymptotic_from = 20;

/// The transform of I1, 2 sinh^2 x / (x (sinh 2x + 2x)). Ooura's rule evaluates it from 1e-170 to beyond the overflow
/// of sinh. Both rules are made for slow decay like its 1/x. On the smooth remainder without tanh x / x, QAWF misses
/// the whole integrand for small alpha, where the first cycle is 1e6 wide.
double transform(double x) {
  if (x > asymptotic_from) return 1 / x;
  if (x < 1e-8) return 0.5;
  const double sine = std::sinh(x);
  return 2 * sine * sine / (x * (std::sinh(2 * x) + 2 * x));
}

double transform_for_gsl(double x, void*) { return transform(x); }

/// Workspaces of gsl_integration_qawf, made once.
class Qawf {
 public:
  double integrate(double omega) {
    gsl_function function{transform_for_gsl, nullptr};
    // The length that QAWF itself uses: with any other length the table would be computed twice.
    const double cycle = (2 * std::floor(omega) + 1) * std::numbers::pi / omega;
    gsl_integration_qawo_table_set(table_.get(), omega, cycle, GSL_INTEG_COSINE);
    double value = std::numeric_limits<double>::quiet_NaN();
    double error_estimate = 0;
    gsl_integration_qawf(&function, 0, tolerance, limit, intervals_.get(), cycles_.get(), table_.get(),
                         &value, &error_estimate);
    return value;
  }

 private:
  static constexpr double tolerance = 1e-13;  // with 1e-14 QAWF gives up at alpha = 1e-6 and errs by 1e-7
  static constexpr std::size_t limit = 1000;
  static constexpr std::size_t chebyshev_levels = 25;

  using Workspace = std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)>;
  using Table = std::unique_ptr<gsl_integration_qawo_table, decltype(&gsl_integration_qawo_table_free)>;
  Workspace intervals_{gsl_integration_workspace_alloc(limit), gsl_integration_workspace_free};
  Workspace cycles_{gsl_integration_workspace_alloc(limit), gsl_integration_workspace_free};
  Table table_{gsl_integration_qawo_table_alloc(1, 1, GSL_INTEG_COSINE, chebyshev_levels),
               gsl_integration_qawo_table_free};
};

}  // namespace

std::function<double(double)> make_plain_series_I1() {
  return [](double alpha) { return fast::plain_series_I1(alpha, 500); };
}

std::function<double(double)> make_qawf_I1() {
  // GSL's own handler would end the program; here a missed tolerance only shows as a larger measured error.
  gsl_set_error_handler_off();
  return [qawf = std::make_shared<Qawf>()](double alpha) { return qawf->integrate(alpha); };
}

std::function<double(double)> make_ooura_I1() {
  using Rule = boost::math::quadrature::ooura_fourier_cos<double>;
  return [rule = std::make_shared<Rule>()](double alpha) { return rule->integrate(transform, alpha).first; };
}

}  // namespace nipref::verify
