#pragma once
#include <stdexcept>

#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

/// The parts of the symbols of the sheet's kernels in a cell of the complex plane, to 64 bits.
struct SymbolSizes {
  static constexpr mpfr_prec_t bits = 64;

  explicit SymbolSizes(const nipref::ref::ComplexInterval& place)
      : z(place), e2(exp(number(-2) * z)), q(one - e2 * e2 + number(4) * z * e2) {}

  /// |G| e^{r Re z}: 4/Q, 2 (1 - e2)/(z Q), 2 (1 + e2)/Q, 2 (1 - e2)/Q, 4/(z Q) and 2 (1 + e2)/(z Q); not for `normal`.
  [[nodiscard]] nipref::ref::Interval of(nipref::ref::Symbol symbol) const {
    using nipref::ref::Symbol;
    const auto difference = abs(one - e2), sum = abs(one + e2);
    switch (symbol) {
      case Symbol::I3:
        return 4 / abs(q);
      case Symbol::I4:
        return 2 * difference / abs(z * q);
      case Symbol::I5:
        return 2 * sum / abs(q);
      case Symbol::I7:
        return 2 * difference / abs(q);
      case Symbol::I6_alpha_part:
        return 4 / abs(z * q);
      case Symbol::I6_eta_part:
        return 2 * sum / abs(z * q);
      default:
        throw std::logic_error("the symbol of I1 has a form of its own");
    }
  }

  static nipref::ref::Interval number(double x) { return {x, bits}; }

  const nipref::ref::ComplexInterval one{number(1), number(0)};
  nipref::ref::ComplexInterval z;
  nipref::ref::ComplexInterval e2;  ///< e^{-2z}
  nipref::ref::ComplexInterval q;   ///< 1 - e2^2 + 4 z e2 = 2 e2 S
};
