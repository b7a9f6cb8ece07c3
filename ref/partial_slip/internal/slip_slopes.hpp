#pragma once
#include <nipref/ref/partial_slip/internal/slip_contact.hpp>

namespace nipref::ref {

/// The residual of a contact is this matrix times its unknowns over their sizes, followed by 1; each entry is precise in double,
/// although equations next to a panel's end are differences.
Eigen::MatrixXd slopes(const SlipContact& contact);

}  // namespace nipref::ref
