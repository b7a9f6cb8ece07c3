#pragma once
#include <memory>

#include <nipref/fast/sheet/generator/number.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::generator {

/// The numbers of one component, each rounded once from 100 digits.
std::unique_ptr<internal::ComponentTable> tabulate(internal::Component component,
                                                   const std::vector<Complex>& roots);

/// The numbers that all components share.
internal::CommonTable tabulate_common(const std::vector<Complex>& roots);

internal::RootTable tabulate_roots(const std::vector<Complex>& roots);

}  // namespace nipref::fast::generator
