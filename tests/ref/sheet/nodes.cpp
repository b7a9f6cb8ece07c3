#include <gmpxx.h>

#include <nipref/ref/number/caches.hpp>
#include <nipref/ref/sheet/internal/nodes.hpp>
#include <nipref/ref/sheet/internal/transform.hpp>
#include <nipref/ref/sheet/kernels.hpp>

#include "support/all_symbols.hpp"
#include "support/intervals.hpp"
#include "support/test.hpp"

using namespace nipref::ref;

namespace {

/// The k-th node of a block, in units of 2^-F.
mpz_class node(const NodeBlock& block, std::size_t k) {
  return signed_integer(&block.values[k * block.limbs], block.limbs);
}

/// The largest difference between nodes of `coarse` and `fine`, in units of `coarse`.
double worst_node_error(const Nodes& coarse, const Nodes& fine) {
  const long extra = fine.key.fraction_bits - coarse.key.fraction_bits;
  double worst = 0;
  for (std::size_t b = 0; b < coarse.blocks.size(); ++b) {
    for (std::size_t k = 0; k < coarse.blocks[b].size(); ++k) {
      const mpz_class rough = node(coarse.blocks[b], k) << static_cast<unsigned>(extra);
      const mpz_class exact = node(fine.blocks[b], k);
      worst = std::max(
          worst,
          mpq_class(mpz_class(abs(rough - exact)), mpz_class(1) << static_cast<unsigned>(extra)).get_d());
    }
  }
  return worst;
}

/// Half the width of an interval of about 128 bits, in units of 2^-128; if `relative`, over the smallest magnitude.
double units(const Interval& x, bool relative) {
  Float width = zero_of_bits(64), least = zero_of_bits(64);
  mpfi_diam_abs(raw(width), x.get());
  mpfi_mig(raw(least), x.get());
  if (relative) mpfr_div(raw(width), raw(width), raw(least), MPFR_RNDU);
  return std::ldexp(mpfr_get_d(raw(width), MPFR_RNDU), 127);
}

}  // namespace

TEST_CASE("nodes are within a unit of nodes with many more digits") {
  for (const Symbol symbol : all_symbols) {
    for (const double step : {0.25, 0.0078125}) {
      CAPTURE(bounds(symbol).name, step);
      const Nodes coarse = make_nodes({symbol, step, 64});
      const Nodes fine = make_nodes({symbol, step, 192});
      const double worst = worst_node_error(coarse, fine);
      CHECK(worst <= 1);
      CHECK(worst > 0.4);  // rounded, so somewhere near half a unit
      CHECK(fine.last > coarse.last);
    }
  }
}

TEST_CASE("a node's rounding is as counted: 70, 145 and 1500 units of its exponentials, 2^12/h, 2^13/h^2") {
  // The same steps in intervals, rounded outwards with one bit more than the 128 bits of the count.
  constexpr mpfr_prec_t bits = 129;
  for (const double h : {0.25, 0.1875, 0x1p-6, 0x1.cp-9}) {
    for (const long first : {0L, 32L, 160L, 3200L}) {
      const auto powers = [&](double rate, long j) {
        return exp(Interval(-rate * static_cast<double>(j) * h, bits));
      };
      Interval e1 = powers(1, first), u = powers(1.5, first);
      for (long j = first; j < first + 32; ++j) {
        if (j > first) {
          e1 = e1 * powers(1, 1);
          u = u * powers(1.5, 1);
        }
        if (j == 0) continue;
        const Interval x(static_cast<double>(j) * h, bits), e2 = square(e1);
        const Interval q = 4 * (x * e2) + (1 - square(e2));
        CAPTURE(h, j);
        CHECK(units(e1, true) <= 70);
        CHECK(units(e2, true) <= 145);
        CHECK(units(q, false) <= 1500);
        for (const Interval& numerator :
             {4 * e2, 2 * (e1 * (1 - e2)), 2 * (e1 * (e2 + 1)), 4 * e2 / x, 2 * (e1 * (e2 + 1)) / x})
          CHECK(units(numerator / q, true) <= 0x1p12 / h);
        const Interval normal = 2 * (u / (u + 1) * q - (2 * x + 1 - e2) * e2) / x / q;
        CHECK(units(normal, false) <= 0x1p13 / (h * h));
      }
    }
  }
}

TEST_CASE("the nodes left out are as small as promised") {
  for (const Symbol symbol : all_symbols) {
    CAPTURE(bounds(symbol).name);
    const Nodes coarse = make_nodes({symbol, 0.125, 64});
    const Nodes fine = make_nodes({symbol, 0.125, 256});
    mpz_class left_out(0);
    for (const NodeBlock& block : fine.blocks) {
      for (std::size_t k = 0; k < block.size(); ++k) {
        if (block.first + static_cast<long>(k) > coarse.last) left_out += abs(node(block, k));
      }
    }
    const double units = mpq_class(left_out, mpz_class(1) << 192U).get_d();
    CHECK(units <= truncation_units);
    CHECK(units > 1e-6 * truncation_units);
  }
}

TEST_CASE("the store hands out one set for one key") {
  const NodeKey key{Symbol::I7, 0.25, 96};
  CHECK(nodes(key) == nodes(key));
}

TEST_CASE("transforms asked for with different accuracy enclose the same number") {
  for (const Symbol symbol : all_symbols) {
    for (const char* text : {"1e-30", "0.4", "6", "90"}) {
      CAPTURE(bounds(symbol).name, text);
      const Exact x = Exact::parse(text);
      const Interval finest = transform(symbol, x, 600 + 2.2 * x.approximate());
      for (const double nats : {40.0, 150.0, 350.0}) {
        const Interval coarse = transform(symbol, x, nats + 2.2 * x.approximate());
        CHECK(is_inside(finest, coarse));
      }
    }
  }
}

TEST_CASE("twice the digits take twice as many nodes of twice the length, not four times as many") {
  const auto bytes = [](int digits) {
    clear_caches();
    I1(Exact::parse("0.73"), digits);
    return static_cast<double>(cached_bytes());
  };
  const double half = bytes(500);
  CHECK(bytes(1000) < 5 * half);
}
