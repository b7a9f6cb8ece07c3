#include <algorithm>
#include <cmath>

#include <nipref/ref/memory/internal/ray_nodes.hpp>
#include <nipref/ref/number/internal/memo.hpp>
#include <nipref/ref/number/real.hpp>

namespace nipref::ref {
namespace {

/// Computes nodes one by one.
class Ray {
 public:
  /// Near 0 the digits of 1 - e^{-2z} are lost as z falls, hence more of them here than are kept.
  explicit Ray(const RayKey& key)
      : key_(key),
        bits_(key.bits + static_cast<mpfr_prec_t>(-1.5 * lowest_exponent(key)) + 16),
        direction_(bits_),
        radius_(bits_),
        slope_(bits_),
        z_(bits_),
        decay_(bits_),
        numerator_(bits_),
        denominator_(bits_),
        square_(bits_) {
    mpfr_set_d(radius_.get(), 0.5, MPFR_RNDN);
    mpfr_sin_cos(mpc_imagref(direction_.get()), mpc_realref(direction_.get()), radius_.get(), MPFR_RNDN);
  }

  void compute(long j, RayNode& node) {
    place(static_cast<double>(j) * key_.step);
    symbol();
    mpc_div(numerator_.get(), numerator_.get(), denominator_.get(), MPC_RNDNN);
    mpc_mul_fr(node.weight.get(), numerator_.get(), slope_.get(), MPC_RNDNN);
    mpc_set(node.z.get(), z_.get(), MPC_RNDNN);
  }

 private:
  /// ln |z| of the first node, < 0.
  static double lowest_exponent(const RayKey& key) {
    const double s = static_cast<double>(key.first) * key.step;
    return std::min(0.0, s - std::exp(key.knee - s));
  }

  /// z, and dz/ds as a multiple of z.
  void place(double s) {
    mpfr_set_d(slope_.get(), key_.knee, MPFR_RNDN);
    mpfr_sub_d(slope_.get(), slope_.get(), s, MPFR_RNDN);
    mpfr_exp(slope_.get(), slope_.get(), MPFR_RNDN);
    mpfr_d_sub(radius_.get(), s, slope_.get(), MPFR_RNDN);
    mpfr_exp(radius_.get(), radius_.get(), MPFR_RNDN);
    mpfr_add_ui(slope_.get(), slope_.get(), 1, MPFR_RNDN);
    mpc_mul_fr(z_.get(), direction_.get(), radius_.get(), MPC_RNDNN);
  }

  /// E = e^{-z}; 0 where 1 swallows it, as MPC is slow at what underflows.
  void set_decay() {
    if (mpfr_cmp_si(mpc_realref(z_.get()), bits_) > 0) {
      mpc_set_ui(decay_.get(), 0, MPC_RNDNN);
      return;
    }
    mpc_neg(numerator_.get(), z_.get(), MPC_RNDNN);
    mpc_exp(decay_.get(), numerator_.get(), MPC_RNDNN);
  }

  /// z G(z) as numerator over denominator, E = e^{-z}:
  ///   I1: (1 - E^2)^2/D, I3: 4 z E^2/D, I4: 2 E (1 - E^2)/D, I5: 2 z E (1 + E^2)/D, D = 1 - E^4 + 4 z E^2
  void symbol() {
    mpc_ptr n = numerator_.get();
    mpc_ptr d = denominator_.get();
    set_decay();
    mpc_sqr(square_.get(), decay_.get(), MPC_RNDNN);
    mpc_mul(d, z_.get(), square_.get(), MPC_RNDNN);
    mpc_mul_2ui(d, d, 2, MPC_RNDNN);
    mpc_add_ui(d, d, 1, MPC_RNDNN);
    mpc_sqr(n, square_.get(), MPC_RNDNN);
    mpc_sub(d, d, n, MPC_RNDNN);
    switch (key_.kernel) {
      case MemoryKernel::I1:
        mpc_ui_sub(n, 1, square_.get(), MPC_RNDNN);
        mpc_sqr(n, n, MPC_RNDNN);
        break;
      case MemoryKernel::I3:
        mpc_mul(n, z_.get(), square_.get(), MPC_RNDNN);
        mpc_mul_2ui(n, n, 2, MPC_RNDNN);
        break;
      case MemoryKernel::I4:
        mpc_ui_sub(n, 1, square_.get(), MPC_RNDNN);
        mpc_mul(n, n, decay_.get(), MPC_RNDNN);
        mpc_mul_2ui(n, n, 1, MPC_RNDNN);
        break;
      case MemoryKernel::I5:
        mpc_add_ui(n, square_.get(), 1, MPC_RNDNN);
        mpc_mul(n, n, decay_.get(), MPC_RNDNN);
        mpc_mul(n, n, z_.get(), MPC_RNDNN);
        mpc_mul_2ui(n, n, 1, MPC_RNDNN);
        break;
    }
  }

  RayKey key_;
  mpfr_prec_t bits_;
  Complex direction_;
  Real radius_;
  Real slope_;
  Complex z_;
  Complex decay_;
  Complex numerator_;
  Complex denominator_;
  Complex square_;
};

RayNodes make_ray_nodes(const RayKey& key) {
  RayNodes nodes;
  Ray ray(key);
  for (long j = key.first; j <= key.last; ++j) ray.compute(j, nodes.emplace_back(key.bits));
  return nodes;
}

std::size_t size_in_bytes(const RayNodes& nodes) {
  if (nodes.empty()) return 0;
  constexpr std::size_t parts = 4;  // real and imaginary ones of z and the weight
  const std::size_t digits = mpfr_custom_get_size(mpfr_get_prec(mpc_realref(nodes.front().z.get())));
  return nodes.size() * (sizeof(RayNode) + parts * digits);
}

}  // namespace

std::shared_ptr<const RayNodes> ray_nodes(const RayKey& key) {
  static Memo<RayKey, RayNodes> kept(make_ray_nodes, size_in_bytes);
  return kept.at(key);
}

}  // namespace nipref::ref
