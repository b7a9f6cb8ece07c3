#pragma once
#include <memory>
#include <vector>

#include <nipref/fast/sheet/generator/number.hpp>
#include <nipref/fast/sheet/internal/field_table.hpp>

namespace nipref::fast::generator {

/// The numbers of the field inside the sheet, each rounded once from 100 digits. The coefficients of the rest are the
/// moments of 2 sinh z/S - 2 e^{-z} and 2 cosh z/S - 2 e^{-z}, where S = sinh 2z + 2z.
std::unique_ptr<internal::FieldTable> tabulate_field(const std::vector<Complex>& roots);

}  // namespace nipref::fast::generator
