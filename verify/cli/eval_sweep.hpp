#pragma once
#include <ostream>

#include <nipref/verify/cli/evaluation.hpp>

namespace nipref::verify {

/// eval with ranges or lists among its arguments: a row for each combination, in their order whatever the threads, as
/// CSV or JSON, with the paths that missed the accuracy. Combinations outside the domain have no values but what was
/// refused. 1 if a row was refused or missed its accuracy; BadInput, the first row's, if all are refused.
int eval_sweep(const EvalRequest& request, const CommandLine& line, std::ostream& out);

}  // namespace nipref::verify
