#pragma once
#include <memory>

#include <nipref/fast/sheet/generator/series.hpp>
#include <nipref/fast/sheet/internal/field_table.hpp>
#include <nipref/fast/sheet/internal/tables.hpp>

namespace nipref::fast::generator {

/// The table of one component, each number rounded once from 100 digits.
std::unique_ptr<internal::ComponentTable> tabulate(internal::Component component);

/// The table of the numbers that all components share.
internal::CommonTable tabulate_common();

internal::RootTable tabulate_roots();

/// The table for the field inside the sheet. The coefficients of the rest are the moments of 2 sinh z/S - 2 e^{-z} and
/// 2 cosh z/S - 2 e^{-z}, where S = sinh 2z + 2z.
std::unique_ptr<internal::FieldTable> tabulate_field();

}  // namespace nipref::fast::generator
