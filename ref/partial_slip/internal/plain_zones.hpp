#pragma once
#include <nipref/ref/nip/internal/sheet_kernels.hpp>
#include <nipref/ref/partial_slip/internal/slip_problem.hpp>

namespace nipref::ref {

/// A guess at the zones of a contact, to about a hundredth of its length, from equal elements in double: where an element sticks
/// its leading edge strains like the roller, and elements change between stick and slip until no inequality is violated.
/// `length` is that of the contact, or a guess at it where the load is given.
Row<SlipZone> plain_zones(const SlipProblem& problem, SheetKernels& kernels, double length);

}  // namespace nipref::ref
