#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/number/internal/complex_interval.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// The largest double of four significant bits that is at most `limit`, so that j h is exact.
double contour_step(double limit);

/// The parameters of a block of nodes t = j h of the path z = sinh(t + i angle). Blocks are cached, and shared by all load
/// positions and rates with the same key.
struct ContourKey {
  Symbol kernel;
  double angle;
  double step;       ///< h, of so few significant bits that j h is exact
  mpfr_prec_t bits;  ///< of the intervals
  long block;        ///< j = nodes_in_block block, ...

  auto operator<=>(const ContourKey&) const = default;
};

inline constexpr long nodes_in_block = 32;

struct ContourNode {
  ComplexInterval z;
  ComplexInterval weight;  ///< G(z) dz/dt, G the kernel's whole symbol
};

using ContourNodes = std::vector<ContourNode>;

/// The nodes for `key`, computed at the first call and then cached. Thread-safe.
std::shared_ptr<const ContourNodes> contour_nodes(const ContourKey& key);

}  // namespace nipref::ref
