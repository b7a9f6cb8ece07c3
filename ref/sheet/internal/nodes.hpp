#pragma once
#include <gmpxx.h>

#include <memory>
#include <vector>

#include <nipref/ref/sheet/internal/symbols.hpp>

namespace nipref::ref {

/// The parameters of a set of nodes. Sets are cached; all arguments and kernels with the same key share them.
struct NodeKey {
  Symbol symbol;
  double step;         ///< h: a double with at most 3 significant bits, so that j h is exact
  long fraction_bits;  ///< F: nodes are fixed-point numbers in units of 2^-F

  auto operator<=>(const NodeKey&) const = default;
};

/// Successive nodes g_j = h G(j h) with the same number of limbs. As the symbol decays, leading limbs that are 0 are
/// left out.
struct NodeBlock {
  long first;         ///< j of the first node
  std::size_t limbs;  ///< limbs of a node: two's complement, least significant limb first, units of 2^-F
  long magnitude;  ///< |b_j| <= 2^magnitude for the Clenshaw sums b_j = sum_{k>=j} g_k U_{k-j} that start in
                   ///< this block
  std::vector<mp_limb_t> values;  ///< g_j, one after the other

  [[nodiscard]] std::size_t size() const { return values.size() / limbs; }
};

/// Nodes j = 0 .. last. g_0 is halved for even symbols and 0 for odd ones; for a twofold pole see ref/sheet/README.md.
///
/// Promise: the error of each stored number is at most one unit 2^-F, and the nodes after the last obey
/// sum_{j > last} |g_j| <= C' h q^{last+1}/(1 - q) <= 2^8 units with q = e^{-r h}, C' = effective_amplitude.
struct Nodes {
  NodeKey key;
  long last;
  std::vector<NodeBlock> blocks;
};

/// The allowed truncation error of Nodes, in units 2^-F: about the rounding error of a sum over some hundred nodes.
constexpr long truncation_units = 256;

/// The integer with these limbs in two's complement.
mpz_class signed_integer(const mp_limb_t* x, std::size_t limbs);

/// C' with |G(j h)| <= C' e^{-r j h} for j >= 1: SymbolBounds::amplitude, divided by h^k where the symbol has
/// a pole of order k at 0 (h <= 1).
double effective_amplitude(const NodeKey& key);

/// The nodes for `key`, computed at the first call and then cached. Thread-safe.
std::shared_ptr<const Nodes> nodes(const NodeKey& key);

/// Computes the nodes without the cache.
Nodes make_nodes(const NodeKey& key);

}  // namespace nipref::ref
