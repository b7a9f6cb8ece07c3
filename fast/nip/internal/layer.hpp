#pragma once
#include <complex>
#include <memory>
#include <vector>

namespace nipref::fast {

/// The pressure -(2 rate/sqrt pi) D(sqrt(rate e)) over e > 0, Re rate >= 0. With the kernel -ln|e - e'|/pi it causes
/// the displacement e^(-rate e) plus a constant, because H[D] = -(sqrt pi/2) e^(-x^2), H the Hilbert transform. D is
/// Dawson's integral, D(z) = z int_0^1 e^(-z^2 (1 - t^2)) dt.
class LayerPressure {
 public:
  explicit LayerPressure(std::complex<double> rate);

  [[nodiscard]] std::complex<double> rate() const { return rate_; }
  [[nodiscard]] std::complex<double> operator()(double e) const;

 private:
  std::complex<double> rate_, root_;
  std::shared_ptr<const std::vector<std::vector<std::complex<double>>>> ray_;  ///< D(z)/z, see layer.cpp
};

}  // namespace nipref::fast
