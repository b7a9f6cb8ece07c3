// Compiled once for each instruction set, whose name is NIPREF_ISA.

#include <nipref/fast/sheet/arithmetic/coarse_batch.hpp>
#include <nipref/fast/sheet/arithmetic/decays.hpp>
#include <nipref/fast/sheet/internal/dispatch.hpp>

namespace nipref::fast::internal::NIPREF_ISA {
namespace {

/// Compares the doubles' bits as integers, which have the same order. A magnitude outside the domain makes one of the
/// differences negative.
bool all_in_domain(const double* argument, size_t count, Domain domain) {
  constexpr int64_t largest = 0x7fefffffffffffff;
  const int64_t smallest = domain == Domain::finite_nonzero ? 1 : 0;
  int64_t signs = 0;
  for (size_t i = 0; i < count; ++i) {
    const auto magnitude = static_cast<int64_t>(bits_of(__builtin_fabs(argument[i])));
    signs |= (largest - magnitude) | (magnitude - smallest);
  }
  return signs >= 0;
}

template <Component component, int tier>
double scalar(double argument) {
  const Pair value = evaluate<component, tier>(__builtin_fabs(argument));
  return with_symmetry<component>(value.high + value.low, argument);
}

template <int tier>
double scalar_i6(double alpha, double eta) {
  const double a = __builtin_fabs(alpha);
  const double e = __builtin_fabs(eta);
  return combine_i6(a, e, evaluate<Component::alpha_part_of_I6, tier>(a),
                    evaluate<Component::eta_part_of_I6, tier>(e));
}

/// Calls evaluate(arguments, values, n) for blocks of whole vectors; the last vector is padded with a valid argument.
template <size_t inputs, typename Evaluate>
NIPREF_INLINE void in_blocks(const double* const (&argument)[inputs], double* value, size_t count,
                             Evaluate evaluate) {
  const size_t whole = count - count % lanes;
  const double* block[inputs];
  for (size_t start = 0; start < whole; start += block_size) {
    const size_t n = whole - start < block_size ? whole - start : block_size;
    for (size_t k = 0; k < inputs; ++k) block[k] = argument[k] + start;
    evaluate(block, value + start, static_cast<int32_t>(n));
  }
  if (whole == count) return;
  double last[inputs][lanes];
  double last_value[lanes];
  for (size_t k = 0; k < inputs; ++k) {
    for (size_t i = 0; i < lanes; ++i) last[k][i] = whole + i < count ? argument[k][whole + i] : 1;
    block[k] = last[k];
  }
  evaluate(block, last_value, lanes);
  for (size_t i = whole; i < count; ++i) value[i] = last_value[i - whole];
}

/// A component at a block of arguments: its values in `high`, or their high and low words.
template <Component component, int tier, Words words>
void evaluate_block(const double* argument, int32_t n, double* high, double* low) {
  if constexpr (tier_works[tier].coarse) {
    CoarseBlock block;
    coarse_block<component, tier>(argument, n, block, high);
    if constexpr (words == Words::two)
      for (int32_t i = 0; i < n; ++i) low[i] = 0;
  } else {
    SortedPoints points;
    SortedValues values;
    sort<component>(argument, n, points);
    evaluate_sorted<component, tier, words>(points, values);
    restore_order<component>(argument, n, points, values.high, high);
    if constexpr (words == Words::two) restore_order<component>(argument, n, points, values.low, low);
  }
}

template <Component component, int tier>
void batch(const double* argument, double* value, size_t count) {
  in_blocks({argument}, value, count, [](const double* const(&x)[1], double* block_value, int32_t n) {
    evaluate_block<component, tier, Words::rounded>(x[0], n, block_value, nullptr);
  });
}

/// One of the two parts of I6 at a block of arguments.
struct PartOfI6 {
  alignas(64) double high[block_size];
  alignas(64) double low[block_size];
};

template <int tier>
void batch_i6(const double* alpha, const double* eta, double* value, size_t count) {
  PartOfI6 r;
  PartOfI6 s;
  in_blocks({alpha, eta}, value, count, [&](const double* const(&x)[2], double* block_value, int32_t n) {
    evaluate_block<Component::alpha_part_of_I6, tier, Words::two>(x[0], n, r.high, r.low);
    evaluate_block<Component::eta_part_of_I6, tier, Words::two>(x[1], n, s.high, s.low);
    for (int32_t i = 0; i < n; ++i) {
      block_value[i] = combine_i6(__builtin_fabs(x[0][i]), __builtin_fabs(x[1][i]), {r.high[i], r.low[i]},
                                  {s.high[i], s.low[i]});
    }
  });
}

}  // namespace

// clang-format off
#define NIPREF_TIERS(function, component) \
  {function<component, 0>, function<component, 1>, function<component, 2>, function<component, 3>, function<component, 4>}
// clang-format on
static_assert(tier_count == 5);

const SheetCode code = {
    NIPREF_ISA_NAME,
    all_in_domain,
    {NIPREF_TIERS(scalar, Component::I1), NIPREF_TIERS(scalar, Component::I3),
     NIPREF_TIERS(scalar, Component::I4), NIPREF_TIERS(scalar, Component::I5),
     NIPREF_TIERS(scalar, Component::I7), NIPREF_TIERS(scalar, Component::eta_part_of_I6)},
    {NIPREF_TIERS(batch, Component::I1), NIPREF_TIERS(batch, Component::I3),
     NIPREF_TIERS(batch, Component::I4), NIPREF_TIERS(batch, Component::I5),
     NIPREF_TIERS(batch, Component::I7)},
    {scalar_i6<0>, scalar_i6<1>, scalar_i6<2>, scalar_i6<3>, scalar_i6<4>},
    {batch_i6<0>, batch_i6<1>, batch_i6<2>, batch_i6<3>, batch_i6<4>},
    decays,
    waves,
    even_rest,
};

}  // namespace nipref::fast::internal::NIPREF_ISA
