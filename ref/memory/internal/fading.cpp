#include <algorithm>
#include <cmath>
#include <numbers>

#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/memory/internal/ray_nodes.hpp>

namespace nipref::ref {
namespace {

constexpr double half_strip = 0.45;
constexpr double margin = 10;
constexpr double ln2 = std::numbers::ln2;
// Grains to which the choices are rounded, so that many arguments share their nodes.
constexpr double nats_grain = 16;
constexpr double end_grain = 4;

double round_up(double x, double grain) { return std::ceil(x / grain) * grain; }

/// Largest double of four significant bits that is at most `limit`, so that j h is exact.
double round_step(double limit) {
  int exponent = 0;
  const double fraction = std::frexp(limit, &exponent);
  return std::ldexp(std::floor(fraction * 16), exponent - 4);
}

/// ln of the |z| beyond which the integrand is below e^{-nats}.
double upper_end(MemoryKernel kernel, double ln_alpha, double ln_rate, double nats) {
  const double by_wave = std::log(nats / std::sin(0.5)) - ln_alpha;
  const double by_symbol =
      kernel == MemoryKernel::I1 ? std::max(0.0, ln_rate) + nats : std::log(nats / std::cos(0.5));
  return std::min(by_wave, by_symbol) + 0.5;
}

/// The ray's nodes, of which the integrand needs `count`.
struct Rule {
  RayKey key;
  std::size_t count;
};

Rule make_rule(MemoryKernel kernel, double ln_alpha, double ln_rate, double nats) {
  const double needed = round_up(nats + margin + std::max(0.0, -ln_rate), nats_grain);
  const double lowest = std::min({0.0, ln_rate, -ln_alpha});
  Rule rule{};
  rule.key.kernel = kernel;
  rule.key.knee = -round_up(-lowest, end_grain) - 1.5;
  rule.key.step = round_step(2 * std::numbers::pi * half_strip / needed);
  // Of the integrand, |z| (|alpha| + 1/rate)/rate at most at the lower end, knee takes care of the factors.
  const double lower_nats = needed + margin - 3 * rule.key.knee;
  const double lower = rule.key.knee - std::log(lower_nats);
  const double upper = upper_end(kernel, ln_alpha, ln_rate, needed + margin);
  const auto index = [&](double s) { return static_cast<long>(std::ceil(s / rule.key.step)); };
  rule.key.first = index(lower);
  rule.key.last = index(round_up(upper, end_grain));
  rule.key.bits = static_cast<mpfr_prec_t>(needed / ln2) + 32;
  rule.count = static_cast<std::size_t>(index(upper) - rule.key.first + 1);
  return rule;
}

/// G(z) dz/ds e^{i |alpha| z}/(rate -+ i z), - where the load has yet to come.
class Integrand {
 public:
  Integrand(const Exact& alpha, const Exact& rate, mpfr_prec_t bits)
      : turn_(alpha.sign() < 0 ? 1 : -1), alpha_(bits), rate_(bits), value_(bits), divisor_(bits) {
    mpfr_set_q(alpha_.get(), alpha.magnitude().value().get_mpq_t(), MPFR_RNDN);
    mpfr_set_q(rate_.get(), rate.value().get_mpq_t(), MPFR_RNDN);
  }

  mpc_srcptr at(const RayNode& node) {
    mpc_mul_fr(value_.get(), node.z.get(), alpha_.get(), MPC_RNDNN);
    mpc_mul_i(value_.get(), value_.get(), 1, MPC_RNDNN);
    mpc_exp(value_.get(), value_.get(), MPC_RNDNN);
    mpc_mul(value_.get(), value_.get(), node.weight.get(), MPC_RNDNN);
    mpc_mul_i(divisor_.get(), node.z.get(), turn_, MPC_RNDNN);
    mpc_add_fr(divisor_.get(), divisor_.get(), rate_.get(), MPC_RNDNN);
    mpc_div(value_.get(), value_.get(), divisor_.get(), MPC_RNDNN);
    return value_.get();
  }

 private:
  int turn_;
  Real alpha_;
  Real rate_;
  Complex value_;
  Complex divisor_;
};

/// The arc around the pole of an odd symbol: (1/2) (1/rate) times the angle 1/2.
void add_arc(Real& sum, const Exact& rate) {
  const mpq_class arc = 1 / (4 * rate.value());
  mpfr_add_q(sum.get(), sum.get(), arc.get_mpq_t(), MPFR_RNDN);
}

}  // namespace

Interval steady_memory(MemoryKernel kernel, const Exact& alpha, const Exact& rate, double nats) {
  const double ln_alpha = alpha.magnitude().log2_magnitude() * ln2;
  const Rule rule = make_rule(kernel, ln_alpha, rate.log2_magnitude() * ln2, nats);
  const auto nodes = ray_nodes(rule.key);
  const bool even = kernel == MemoryKernel::I1;
  Integrand integrand(alpha, rate, rule.key.bits);
  Real sum(rule.key.bits);
  for (std::size_t k = 0; k < rule.count; ++k) {
    const mpc_srcptr value = integrand.at((*nodes)[k]);
    mpfr_add(sum.get(), sum.get(), even ? mpc_realref(value) : mpc_imagref(value), MPFR_RNDN);
  }
  mpfr_mul_d(sum.get(), sum.get(), rule.key.step, MPFR_RNDN);
  if (!even) {
    add_arc(sum, rate);
    if (alpha.sign() < 0) mpfr_neg(sum.get(), sum.get(), MPFR_RNDN);
  }
  return Interval(sum, sum, rule.key.bits).widened(exp(Interval(-nats, 64)));
}

}  // namespace nipref::ref
