#pragma once
#include <functional>
#include <vector>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// A part of the way along a sheet. With x the distance from its left end over its width, a function on it is a
/// polynomial of x, of sqrt(x) or of sqrt(1 - x).
struct TracePanel {
  enum class Root { none, left, right };
  Float left, width;
  Root root;
  int terms;
};

/// A function g of the way x along a sheet, by polynomials on successive panels, and its integrals with a memory. g is
/// 0 before the first panel. Its polynomial on a panel is computed when it is first needed.
class Trace {
 public:
  using Function = std::function<Float(const Float& x)>;

  /// Integrals are good to about e^-nats.
  Trace(std::vector<TracePanel> panels, Function function, double nats);

  /// int_0^inf e^(-rate w) g(x - w) dw, without the part behind the last panel.
  [[nodiscard]] ComplexFloat faded(const ComplexFloat& rate, const Float& x) const;
  /// The same for the integral of g up to x in place of g: the weight of g is then the integral of e^(-rate w) up to w.
  [[nodiscard]] ComplexFloat faded_integral(const ComplexFloat& rate, const Float& x) const;
  /// Where the last panel ends.
  [[nodiscard]] Float end() const;

 private:
  struct Panel {
    TracePanel shape;
    mutable std::vector<Float> coefficients;
  };
  using Weight = std::function<ComplexFloat(const Float& way)>;

  [[nodiscard]] const std::vector<Float>& coefficients(const Panel& panel) const;
  [[nodiscard]] ComplexFloat integral(const ComplexFloat& rate, const Float& x, bool forgets,
                                      const Weight& weight) const;
  [[nodiscard]] ComplexFloat piece(const Panel& panel, const Float& from, const Float& to, const Float& x,
                                   const Weight& weight) const;

  double nats_;
  Function function_;
  std::vector<Panel> panels_;
  UnitRule rule_;
};

/// int_0^way e^(-rate (way - t)) t^k/k! dt
ComplexFloat faded_power(const ComplexFloat& rate, const Float& way, int k);

}  // namespace nipref::ref
