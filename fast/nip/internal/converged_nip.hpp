#pragma once
#include <memory>
#include <optional>

#include <nipref/fast/nip/converged.hpp>
#include <nipref/fast/nip/internal/domain.hpp>
#include <nipref/fast/nip/internal/nip_equations.hpp>

namespace nipref::fast {

/// One of the two.
struct GivenContact {
  std::optional<double> length = {}, load = {};  ///< L, unit of length; force per unit width
};

/// The solved contact of a nip of these equations. compliance: N (at once). BadInput for an accuracy, a length or a load
/// outside the domain, and for a load whose contact is.
ConvergedNip converged_nip(const NipShape& shape, double compliance,
                           std::shared_ptr<const NipEquations> equations, const GivenContact& given,
                           double accuracy);

}  // namespace nipref::fast
