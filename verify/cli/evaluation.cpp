#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/met.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/evaluation.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr auto right_form = "corrected";

const Quantity& quantity_of(const CommandLine& line) {
  if (line.words.size() > 1) {
    throw BadInput("argument", line.words[1], "unexpected: eval takes one quantity and name=value pairs");
  }
  return find_quantity(line.words.empty() ? "(missing)" : line.words.front());
}

/// Null for the right one.
const SeedForm* form_of(const CommandLine& line, const Quantity& quantity) {
  const std::string form = line.option("form").value_or(right_form);
  if (form == right_form) return nullptr;
  std::vector<std::string> known{right_form};
  for (const SeedForm& candidate : quantity.seed_forms) {
    if (candidate.name == form && line.option("path"))
      throw BadInput("path", line.option_or_usual("path"),
                     "must be left out with form=" + form + ": that is no path's");
    if (candidate.name == form) return &candidate;
    known.push_back(candidate.name);
  }
  throw BadInput("form", form, fmt::format("must be {} of {}", fmt::join(known, " or "), quantity.name));
}

void refuse_options_without_effect(const CommandLine& line, const std::string& path, const SeedForm* form) {
  const std::string chosen = form != nullptr ? "form=" + form->name : "path=" + path;
  const std::string why = "has no effect with " + chosen + ": must be left out";
  if (form != nullptr || path == "ref") refuse_option(line, "rtol", why);
  if (form != nullptr || path == "fast") refuse_option(line, "digits", why);
}

int digits_for(const Quantity& quantity, const CommandLine& line) {
  const int digits = digits_option(line).value();
  if (!line.option("digits")) return std::min(digits, quantity.most_digits);
  if (digits > quantity.most_digits) {
    throw BadInput(
        "digits", std::to_string(digits),
        fmt::format("must be a whole number from 16 to {} for {}", quantity.most_digits, quantity.name));
  }
  return digits;
}

EvalAnswer answer_of_ref(const EvalRequest& request, const ParsedArguments& arguments) {
  std::optional<ref::Estimate> found;
  const double seconds =
      seconds_of([&] { found = request.quantity->by_ref(arguments.exact, request.digits); });
  return {"ref",
          found->value_text(),
          found->error_text(),
          found->proven,
          request.digits,
          std::pow(10.0L, -request.digits),
          is_met(*request.quantity, arguments, *found, request.digits),
          seconds};
}

EvalAnswer answer_of_fast(const EvalRequest& request, const ParsedArguments& arguments) {
  const Quantity& quantity = *request.quantity;
  const Point point = arguments.nearest(quantity);
  double value = 0;
  const double seconds = seconds_of([&] { value = quantity.by_fast(point, request.accuracy); });
  const double scale = std::max(std::fabs(value), quantity.envelope(point));
  const double rtol = request.accuracy.rtol();
  const double tolerated = rtol > fast::Accuracy::best_rtol ? rtol * scale : 0;
  const double promised = quantity.fast_error ? quantity.fast_error(point, request.accuracy)
                                              : std::max(quantity.promise * ulp_of(scale), tolerated);
  return {"fast",
          fmt::format("{}", value),
          upward_text(promised),
          false,
          static_cast<int>(-std::log10(rtol)),
          rtol,
          request.rtol_is_asked ? std::optional(is_met(promised, scale, rtol)) : std::nullopt,
          seconds};
}

EvalAnswer answer_of_seed(const EvalRequest& request, const ParsedArguments& arguments) {
  const Point point = arguments.nearest(*request.quantity);
  static_cast<void>(
      request.quantity->by_fast(point, request.accuracy));  // refuses what it cannot be asked for
  double value = 0;
  const double seconds = seconds_of([&] { value = request.form->value(point); });
  if (!std::isfinite(value))
    throw BadInput("form", request.form->name, "must be corrected here: the seed's form gives no number");
  return {request.form->name,
          fmt::format("{}", value),
          std::nullopt,
          false,
          std::numeric_limits<double>::digits10,
          0,
          std::nullopt,
          seconds};
}

}  // namespace

EvalRequest request_of(const CommandLine& line) {
  const Quantity& quantity = quantity_of(line);
  const std::string path = line.option_or_usual("path");
  const SeedForm* form = form_of(line, quantity);
  refuse_options_without_effect(line, path, form);
  return {&quantity,
          form,
          form == nullptr && path != "fast",
          form == nullptr && path != "ref",
          digits_for(quantity, line),
          accuracy_option(line),
          line.option("rtol").has_value()};
}

const char* caveat_of(const EvalRequest& request) {
  if (request.quantity->ref_takes_doubles && request.form == nullptr) {
    return "each argument is taken rounded to the nearest double; errors are for that argument.";
  }
  return request.by_fast
             ? "fast takes each argument rounded to the nearest double; its error is for that argument."
             : nullptr;
}

Json caveat_json(const EvalRequest& request) {
  const char* const caveat = caveat_of(request);
  return caveat == nullptr ? Json() : Json(caveat);
}

std::vector<EvalAnswer> answers_to(const EvalRequest& request, const ParsedArguments& arguments) {
  std::vector<EvalAnswer> answers;
  if (request.form != nullptr) answers.push_back(answer_of_seed(request, arguments));
  if (request.by_ref) answers.push_back(answer_of_ref(request, arguments));
  if (request.by_fast) answers.push_back(answer_of_fast(request, arguments));
  return answers;
}

Json number_json(const std::string& path, const std::string& text) {
  return path == "ref" ? Json(text) : Json::number(text);
}

}  // namespace nipref::verify
