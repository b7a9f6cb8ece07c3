#pragma once
#include <deque>
#include <memory>

#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// A path in the plane of the symbols, with real t; see contour_memory().
enum class Contour {
  up,    ///< z = sinh(t + i/2)
  down,  ///< z = 3i/2 + sinh(t - i/2)
  low,   ///< z = sinh(t + i/4), see oscillating_memory()
  high   ///< z = sinh(t + 3i/4)
};

/// The largest double of four significant bits that is at most `limit`, so that j h is exact.
double contour_step(double limit);

/// The parameters of a block of nodes t = j h. Blocks are cached, and shared by all load positions and rates with the
/// same key.
struct ContourKey {
  Symbol kernel;
  Contour contour;
  double step;       ///< h, of so few significant bits that j h is exact
  mpfr_prec_t bits;  ///< p
  long block;        ///< j = nodes_in_block block, ...

  auto operator<=>(const ContourKey&) const = default;
};

inline constexpr long nodes_in_block = 32;

/// A node. Each number has a relative error of at most 2^-p, by interval arithmetic.
struct ContourNode {
  explicit ContourNode(mpfr_prec_t bits) : z(bits), weight(bits) {}
  Complex z;
  Complex weight;  ///< G(z) dz/dt, G the kernel's whole symbol
};

using ContourNodes = std::deque<ContourNode>;

/// The nodes for `key`, computed at the first call and then cached. Thread-safe.
std::shared_ptr<const ContourNodes> contour_nodes(const ContourKey& key);

}  // namespace nipref::ref
