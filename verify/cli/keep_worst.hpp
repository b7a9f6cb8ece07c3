#pragma once
#include <string>

#include <nipref/verify/cli/graded.hpp>

namespace nipref::verify {

/// Appends the worst point of a grade, with the reference's value of 50 digits, to a file like those of data/golden,
/// of which it is the first row if there is none. Nothing if the point is there. BadInput naming "keep-worst" if the
/// file is about another quantity. OutputError if it cannot be written.
void keep_worst(const std::string& path, const Graded& graded);

}  // namespace nipref::verify
