#pragma once
#include <functional>

#include <nipref/ref/number/interval.hpp>
#include <nipref/ref/sheet/internal/smooth_kernel.hpp>

/// Ends, widths and relations of intervals.
inline double highest(const nipref::ref::Interval& x) { return mpfr_get_d(x.upper(), MPFR_RNDU); }
inline double lowest(const nipref::ref::Interval& x) { return mpfr_get_d(x.lower(), MPFR_RNDD); }
inline double width_of(const nipref::ref::Interval& x) {
  nipref::ref::Float found = nipref::ref::zero_of_bits(64);
  mpfi_diam_abs(nipref::ref::raw(found), x.get());
  return mpfr_get_d(nipref::ref::raw(found), MPFR_RNDU);
}
inline bool meet(const nipref::ref::Interval& x, const nipref::ref::Interval& y) {
  return mpfi_cmp(x.get(), y.get()) == 0;
}
inline bool is_inside(const nipref::ref::Interval& part, const nipref::ref::Interval& whole) {
  return mpfi_is_inside(part.get(), whole.get()) > 0;
}
inline bool has_zero(const nipref::ref::Interval& x) { return mpfi_has_zero(x.get()) > 0; }

/// A cell of a mesh, to 64 bits.
inline nipref::ref::Interval cell(double left, double right) {
  nipref::ref::Interval result(64);
  mpfi_interv_d(result.get(), left, right);
  return result;
}

/// Visits the cells of a mesh from 0 to `end` or beyond. The width of a cell is a function of its left end.
inline void over_cells(double end, const std::function<double(double left)>& width,
                       const std::function<void(double left, double right)>& visit) {
  for (double left = 0, right = 0; left < end; left = right) {
    right = left + width(left);
    visit(left, right);
  }
}

/// The kernel with an error in one value, the one that is computed after `count` others.
inline nipref::ref::NormalKernel once_wrong(const nipref::ref::NormalKernel& kernel, int count,
                                            const nipref::ref::Interval& error) {
  return [=, left = count](const nipref::ref::Exact& alpha, double nats) mutable {
    const nipref::ref::Interval value = kernel(alpha, nats);
    return left-- == 0 ? value + error : value;
  };
}
