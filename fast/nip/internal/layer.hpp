#pragma once
#include <complex>
#include <memory>

namespace nipref::fast {

/// The pressure -(2 rate/sqrt pi) D(sqrt(rate e)) over e > 0, whose displacement by the kernel -ln|e - e'|/pi is e^(-rate e)
/// and a constant: that of H[D] = -(sqrt pi/2) e^(-x^2), H the Hilbert transform. D is Dawson's integral, D(z) = z int_0^1
/// e^(-z^2 (1 - t^2)) dt; Re rate >= 0.
class LayerPressure {
 public:
  explicit LayerPressure(std::complex<double> rate);

  [[nodiscard]] std::complex<double> rate() const { return rate_; }
  [[nodiscard]] std::complex<double> operator()(double e) const;

 private:
  std::complex<double> rate_, root_;
  struct DawsonOnRay;
  std::shared_ptr<const DawsonOnRay> ray_;
};

}  // namespace nipref::fast
