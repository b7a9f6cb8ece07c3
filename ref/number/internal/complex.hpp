#pragma once
#include <mpc.h>

namespace nipref::ref {

/// Owns one number of MPC, for MPC's functions.
class Complex {
 public:
  explicit Complex(mpfr_prec_t precision) {
    mpc_init2(value_, precision);
    mpc_set_ui(value_, 0, MPC_RNDNN);
  }
  Complex(const Complex&) = delete;
  Complex& operator=(const Complex&) = delete;
  ~Complex() { mpc_clear(value_); }

  [[nodiscard]] mpc_ptr get() { return value_; }
  [[nodiscard]] mpc_srcptr get() const { return value_; }

 private:
  mpc_t value_;
};

}  // namespace nipref::ref
