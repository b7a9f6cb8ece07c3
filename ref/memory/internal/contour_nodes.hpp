#pragma once
#include <deque>
#include <memory>

#include <nipref/ref/number/internal/complex.hpp>
#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// Which path in the plane of the symbols, see contour_memory(): t is real along it.
enum class Contour {
  up,    ///< z = sinh(t + i/2)
  down,  ///< z = 3i/2 + sinh(t - i/2)
  low,   ///< z = sinh(t + i/4), see swinging_memory()
  high   ///< z = sinh(t + 3i/4)
};

/// Largest double of four significant bits that is at most `limit`, so that j h is exact.
double contour_step(double limit);

/// Which nodes t = j h; they are kept and shared by every load position and every rate that ask for the same.
struct ContourKey {
  Symbol kernel;
  Contour contour;
  double step;       ///< h, of so few significant bits that j h is exact
  mpfr_prec_t bits;  ///< p
  long block;        ///< j = nodes_in_block block, ...

  auto operator<=>(const ContourKey&) const = default;
};

inline constexpr long nodes_in_block = 32;

/// Each number is within 2^-p of its own modulus of the true one, which is found in interval arithmetic.
struct ContourNode {
  explicit ContourNode(mpfr_prec_t bits) : z(bits), weight(bits) {}
  Complex z;
  Complex weight;  ///< G(z) dz/dt, G the kernel's whole symbol
};

using ContourNodes = std::deque<ContourNode>;

/// The nodes for `key`, computed at the first call and kept, see Cache. Thread-safe.
std::shared_ptr<const ContourNodes> contour_nodes(const ContourKey& key);

}  // namespace nipref::ref
