#pragma once
#include <functional>
#include <vector>

#include <nipref/ref/number/internal/chebyshev_sum.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// A part of the way along a sheet. On it a function is a polynomial of the distance from its left end over its width, or
/// of the root of that; or of the root of the distance from its right end.
struct TracePanel {
  enum class Root { none, left, right };
  Float left, width;
  Root root;
  int terms;
};

/// A function of the way x along a sheet by polynomials on panels that follow each other, and what a memory makes of it. It
/// is 0 before the first panel, and computed on a panel when that is first asked for.
class Trace {
 public:
  using Function = std::function<Float(const Float& x)>;

  /// Integrals are good to about e^-nats.
  Trace(std::vector<TracePanel> panels, Function function, double nats);

  /// int_0^inf e^(-rate w) g(x - w) dw, over what the panels have of it.
  [[nodiscard]] ComplexFloat faded(const ComplexFloat& rate, const Float& x) const;
  /// The same of the integral of g up to x: e^(-rate w) is integrated from 0 to w.
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
