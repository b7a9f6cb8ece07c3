#include <doctest/doctest.h>

#include <cmath>

#include "ref/nodes.hpp"
#include "ref/transform.hpp"

using namespace nipref::ref;

namespace {

/// |x - y| in units of 2^-bits.
double distance(const Real& x, const Real& y, long bits) {
  Real difference(64);
  mpfr_sub(difference.get(), x.get(), y.get(), MPFR_RNDU);
  mpfr_mul_2si(difference.get(), difference.get(), bits, MPFR_RNDU);
  return std::abs(mpfr_get_d(difference.get(), MPFR_RNDN));
}

double worst_node_error(const Nodes& coarse, const Nodes& fine) {
  double worst = 0;
  for (std::size_t b = 0; b < coarse.blocks.size(); ++b) {
    const NodeBlock& block = coarse.blocks[b];
    for (std::size_t k = 0; k < block.real.size(); ++k) {
      worst = std::max(worst, distance(block.real[k], fine.blocks[b].real[k], coarse.key.absolute_bits));
      if (!block.imag.empty())
        worst = std::max(worst, distance(block.imag[k], fine.blocks[b].imag[k], coarse.key.absolute_bits));
    }
  }
  return worst;
}

constexpr Symbol all_symbols[] = {Symbol::normal, Symbol::I3,       Symbol::I4,    Symbol::I5,
                                  Symbol::I7,     Symbol::I6_alpha, Symbol::I6_eta};

bool line_is_used(Symbol symbol, Line line) {
  return bounds(symbol).amplitude[static_cast<std::size_t>(line)] > 0;
}

}  // namespace

TEST_CASE("nodes keep their promise of 2^-A/2 against nodes of twice the precision") {
  for (const Symbol symbol : all_symbols) {
    for (const Line line : {Line::real_axis, Line::one, Line::seven_quarters}) {
      if (!line_is_used(symbol, line)) continue;
      for (const double step : {0.25, 0.0078125}) {
        CAPTURE(bounds(symbol).name);
        CAPTURE(height(line));
        CAPTURE(step);
        const Nodes coarse = make_nodes({symbol, line, step, 64});
        const Nodes fine = make_nodes({symbol, line, step, 192});
        CHECK(worst_node_error(coarse, fine) <= 0.5);
        CHECK(fine.last > coarse.last);
        CHECK(mpfr_cmpabs_ui(coarse.blocks.back().real.back().get(), 1) < 0);
      }
    }
  }
}

TEST_CASE("the nodes left out are as small as promised") {
  for (const Symbol symbol : all_symbols) {
    CAPTURE(bounds(symbol).name);
    const NodeKey key{symbol, bounds(symbol).amplitude[0] > 0 ? Line::real_axis : Line::one, 0.125, 64};
    const Nodes coarse = make_nodes(key);
    const Nodes fine = make_nodes({key.symbol, key.line, key.step, 256});
    Real left_out(64);
    for (const NodeBlock& block : fine.blocks) {
      for (std::size_t k = 0; k < block.real.size(); ++k) {
        if (block.first + static_cast<long>(k) <= coarse.last) continue;
        Real size(64);
        mpfr_abs(size.get(), block.real[k].get(), MPFR_RNDU);
        mpfr_add(left_out.get(), left_out.get(), size.get(), MPFR_RNDU);
      }
    }
    mpfr_mul_2ui(left_out.get(), left_out.get(), 64, MPFR_RNDU);
    CHECK(mpfr_cmp_ui(left_out.get(), 1) <= 0);
    CHECK(mpfr_cmp_d(left_out.get(), 1e-6) > 0);
  }
}

TEST_CASE("the store hands out one set for one key") {
  const NodeKey key{Symbol::I7, Line::real_axis, 0.25, 96};
  CHECK(nodes(key) == nodes(key));
}

TEST_CASE("transforms asked for with different accuracy enclose the same number") {
  for (const Symbol symbol : all_symbols) {
    for (const char* text : {"1e-30", "0.4", "6", "90"}) {
      CAPTURE(bounds(symbol).name);
      CAPTURE(text);
      const Exact x = Exact::parse(text);
      const Interval coarse = transform(symbol, x, 40 + 2.2 * x.approximate());
      const Interval fine = transform(symbol, x, 150 + 2.2 * x.approximate());
      CHECK(mpfr_cmp(coarse.lower(), fine.lower()) <= 0);
      CHECK(mpfr_cmp(coarse.upper(), fine.upper()) >= 0);
    }
  }
}
