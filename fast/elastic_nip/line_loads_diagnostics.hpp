#pragma once
#include <span>

#include <nipref/data/problem/friction.hpp>
#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::fast {

/// Condition number of the matching matrix in the 1-norm, estimated from its factors: infinite if it is
/// singular. The matrix is that of line_loads_system.hpp, d0 and the loads times N/pi being lengths.
/// Domains and `work` as for line_loads_for_length.
double condition_number(const data::ElasticNip& nip, const LineLoadMethod& method, double contact_length,
                        data::Friction friction, Work* work = nullptr);

/// How much a row of loads zigzags: the sum of the sizes of its second differences over the sum of its sizes.
/// About (h/l)^2 for a smooth function of length scale l in steps h, up to 4 if every load pulls against the
/// next; 0 if there are fewer than three, or all are 0.
double oscillation(std::span<const double> loads);

}  // namespace nipref::fast
