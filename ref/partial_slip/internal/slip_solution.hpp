#pragma once
#include <memory>
#include <vector>

#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {

/// A guess of the zones of a contact, to about a hundredth of its length, from equal elements in double. At the leading
/// edge an element that sticks strains like the roller. Elements change between stick and slip until no inequality is
/// violated, at a creep that follows from the traction. All zones make up `length`, even if the load is given.
Row<SlipZone> plain_zones(const SlipProblem& problem, SheetKernels& kernels, double length);

/// A contact solved with two grids. The kernels of the coarser one have larger errors, too, so that the difference of
/// both contains what these do.
struct SolvedSlip {
  std::unique_ptr<SheetKernels> coarse_kernels;
  std::unique_ptr<const SlipField> coarse, fine;
};

/// Solves from a guess of the zones, which are corrected until no inequality is violated. Null if that does not end.
SolvedSlip solved_slip(const SlipProblem& problem, SheetKernels& kernels, Row<SlipZone> zones, int digits);

/// Digits that the kernels need, and the working precision.
int kernel_digits_of_slip(int digits);
int working_digits_of_slip(int digits);

}  // namespace nipref::ref
