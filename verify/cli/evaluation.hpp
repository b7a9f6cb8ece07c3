#pragma once
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The result of one path, as it is printed.
struct EvalAnswer {
  std::string path;  ///< or the name of the seed's form
  std::string value;
  std::optional<std::string> error;  ///< nothing for the seed's forms
  bool proven;                       ///< whether the error is a proven bound
  int digits;                        ///< for ref those requested, for fast those promised
  long double accuracy;              ///< requested: 10^-digits, or rtol
  std::optional<bool> met;  ///< nothing where no accuracy is requested; see catalogue/internal/met.hpp
  double seconds;
};

/// The request of a call of eval, checked as far as possible without evaluating anything.
struct EvalRequest {
  const Quantity* quantity;
  const SeedForm* form;  ///< null for the corrected form
  bool by_ref;
  bool by_fast;
  int digits;
  fast::Accuracy accuracy;
  bool rtol_is_asked;
};

/// BadInput for an unknown quantity and for options that exclude each other.
EvalRequest request_of(const CommandLine& line);

/// Says that arguments were rounded before evaluation; null if they were not.
const char* caveat_of(const EvalRequest& request);
Json caveat_json(const EvalRequest& request);

/// The results at these arguments, ref's before fast's. BadInput outside their domain.
std::vector<EvalAnswer> answers_to(const EvalRequest& request, const ParsedArguments& arguments);

/// ref's numbers are JSON text, as they may not fit a double.
Json number_json(const std::string& path, const std::string& text);

/// eval with ranges or lists among its arguments: a row for each combination, in their order whatever the threads, as
/// CSV or JSON, with the paths that missed the accuracy. Combinations outside the domain have no values but what was
/// refused. 1 if a row was refused or missed its accuracy; BadInput, the first row's, if all are refused.
int eval_sweep(const EvalRequest& request, const CommandLine& line, std::ostream& out);

}  // namespace nipref::verify
