#pragma once
#include <nipref/data/problem/seed_nips.hpp>

/// The thesis's nips by their sheets.
namespace nipref::test {

inline constexpr data::ElasticNip thick_nip = data::seed::nip(1.0);
inline constexpr data::ElasticNip quarter_inch_nip = data::seed::nip(0.25);
inline constexpr data::ElasticNip middling_nip = data::seed::nip(0.0625);
inline constexpr data::ElasticNip thin_nip = data::seed::nip(0.005);

}  // namespace nipref::test
