#pragma once
#include <nipref/verify/solve/internal/solved_contact.hpp>

namespace nipref::verify {

/// The size that data::Scale describes for the error of a result, of a profile or a field at `y`, where the scene asks
/// for this accuracy.
template <class Number>
double result_size(const SolvedContact<Number>& contact, ResultId id, double y, double accuracy);

}  // namespace nipref::verify
