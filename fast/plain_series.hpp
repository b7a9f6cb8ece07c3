#pragma once

namespace nipref::fast {

/// The thesis's own way to I1: the first `terms` residues of (AI.9), pi sum e^(-K_n |alpha|) (A_n sin m_n
/// |alpha| + B_n cos m_n |alpha|), evaluated as it stands, with z_n = m_n + i K_n. A peer for speed and
/// accuracy, and what replays the thesis's tables; not a way to compute I1. alpha: dimensionless, finite and
/// nonzero (the series diverges at 0); terms: 1 .. 500; otherwise BadInput. Error: the rest of the series,
/// about e^(-pi |alpha| terms)/(pi |alpha| terms), and rounding. The roots are computed at the first call.
double plain_series_I1(double alpha, int terms);

}  // namespace nipref::fast
