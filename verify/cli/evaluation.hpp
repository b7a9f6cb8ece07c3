#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nipref/fast/number/accuracy.hpp>
#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// One path's answer, as it is printed.
struct EvalAnswer {
  std::string path;  ///< or the name of the seed's form
  std::string value;
  std::optional<std::string> error;  ///< none of the seed's forms
  bool proven;                       ///< that error, as a bound
  int digits;                        ///< ref: as asked for; fast: as promised
  long double accuracy;              ///< that was asked for: 10^-digits, or rtol
  std::optional<bool> met;           ///< none where no accuracy was asked for; see catalogue/internal/met.hpp
  double seconds;
};

/// What eval was asked for, checked as far as it can be without evaluating anything.
struct EvalRequest {
  const Quantity* quantity;
  const SeedForm* form;  ///< null: the right one
  bool by_ref;
  bool by_fast;
  int digits;
  fast::Accuracy accuracy;
  bool rtol_is_asked;
};

/// BadInput for options that do not go together, and for what is no quantity.
EvalRequest request_of(const CommandLine& line);

/// Of which arguments the numbers are, where not of just those that were asked for; null otherwise.
const char* caveat_of(const EvalRequest& request);
Json caveat_json(const EvalRequest& request);

/// What was asked for at these arguments: of ref before fast. BadInput outside their domain.
std::vector<EvalAnswer> answers_to(const EvalRequest& request, const ParsedArguments& arguments);

/// Text is what may not fit a double.
Json number_json(const std::string& path, const std::string& text);

}  // namespace nipref::verify
