#pragma once
#include <nipref/ref/sheet/internal/symbols.hpp>

inline constexpr nipref::ref::Symbol all_symbols[] = {
    nipref::ref::Symbol::I1,          nipref::ref::Symbol::I3, nipref::ref::Symbol::I4,
    nipref::ref::Symbol::I5,          nipref::ref::Symbol::I7, nipref::ref::Symbol::I6_alpha_part,
    nipref::ref::Symbol::I6_eta_part,
};
