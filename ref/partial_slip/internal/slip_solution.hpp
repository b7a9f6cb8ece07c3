#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {

/// A contact solved with two grids.
struct SolvedSlip {
  std::unique_ptr<const SlipField> coarse, fine;
};

/// From a guess at the zones; these are corrected where an inequality is violated. Null where that comes to no end.
SolvedSlip solved_slip(const SlipProblem& problem, SheetKernels& kernels, Row<SlipZone> zones, int digits);

/// Digits that the kernels need, and the working precision.
int kernel_digits_of_slip(int digits);
int working_digits_of_slip(int digits);

}  // namespace nipref::ref
