#pragma once
#include <deque>
#include <memory>

#include <nipref/ref/memory/internal/fading.hpp>
#include <nipref/ref/number/internal/complex.hpp>

namespace nipref::ref {

/// What a set of nodes on the ray arg z = 1/2 is for, see fading.hpp; sets are kept and shared by
/// every load position and every rate that ask for the same.
struct RayKey {
  MemoryKernel kernel;
  double knee;  ///< c of ln |z| = s - e^{c - s}
  double step;  ///< h, of so few significant bits that s = j h is exact
  long first;   ///< nodes j = first .. last
  long last;
  mpfr_prec_t bits;  ///< absolute accuracy of the weights in bits, about

  auto operator<=>(const RayKey&) const = default;
};

struct RayNode {
  explicit RayNode(mpfr_prec_t bits) : z(bits), weight(bits) {}
  Complex z;
  Complex weight;  ///< G(z) dz/ds, G the kernel's symbol
};

using RayNodes = std::deque<RayNode>;

/// The nodes for `key`, computed at the first call and kept, see Memo. Thread-safe.
std::shared_ptr<const RayNodes> ray_nodes(const RayKey& key);

}  // namespace nipref::ref
