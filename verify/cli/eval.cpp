#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/cli/answer.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>
#include <nipref/verify/support/internal/upward_text.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

constexpr auto right_form = "corrected";
constexpr int default_digits = 50;
constexpr auto of_the_nearest_doubles =
    "fast takes each argument rounded to the nearest double; its error is for that argument.";

/// One path's answer, as it is printed.
struct Answer {
  std::string path;  ///< or the name of the seed's form
  std::string value;
  std::optional<std::string> error;  ///< none of the seed's forms
  bool proven;                       ///< that error, as a bound
  int digits;                        ///< ref: as asked for; fast: as promised
  double seconds;
};

/// What errors are measured against at the arguments, and its unit in the last place; none where doubles end.
struct Scale {
  std::optional<double> size, ulp;
};

/// What was asked for, checked as far as it can be without evaluating anything.
struct Request {
  const Quantity* quantity;
  ParsedArguments arguments;
  const SeedForm* form;  ///< null: the right one
  bool by_ref;
  bool by_fast;
  int digits;
  fast::Accuracy accuracy;
};

const Quantity& quantity_of(const CommandLine& line) {
  if (line.words.size() > 1) {
    throw BadInput("argument", line.words[1], "unexpected: eval takes one quantity and name=value pairs");
  }
  return find_quantity(line.words.empty() ? "(missing)" : line.words.front());
}

std::string path_of(const CommandLine& line) {
  const std::string path = line.option("path").value_or("both");
  if (path != "ref" && path != "fast" && path != "both")
    throw BadInput("path", path, "must be ref, fast or both");
  return path;
}

/// Null for the right one.
const SeedForm* form_of(const CommandLine& line, const Quantity& quantity) {
  const std::string form = line.option("form").value_or(right_form);
  if (form == right_form) return nullptr;
  std::vector<std::string> known{right_form};
  for (const SeedForm& candidate : quantity.seed_forms) {
    if (candidate.name == form && line.option("path"))
      throw BadInput("path", path_of(line), "must be left out with form=" + form + ": that is no path's");
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

Request request_of(const CommandLine& line) {
  const Quantity& quantity = quantity_of(line);
  const std::string path = path_of(line);
  const SeedForm* form = form_of(line, quantity);
  refuse_options_without_effect(line, path, form);
  return {&quantity,
          parse_arguments(quantity, line.assignments),
          form,
          form == nullptr && path != "fast",
          form == nullptr && path != "ref",
          digits_option(line, default_digits),
          accuracy_option(line)};
}

Answer answer_of_ref(const Request& request) {
  std::optional<Reference> found;
  const double seconds =
      seconds_of([&] { found = request.quantity->by_ref(request.arguments.exact, request.digits); });
  return {"ref", found->value_text(), found->error_text(), found->proven, request.digits, seconds};
}

Answer answer_of_fast(const Request& request) {
  const Quantity& quantity = *request.quantity;
  const Point point = request.arguments.nearest(quantity);
  double value = 0;
  const double seconds = seconds_of([&] { value = quantity.by_fast(point, request.accuracy); });
  const double scale = std::max(std::fabs(value), quantity.envelope(point));
  const double rtol = request.accuracy.rtol();
  const double tolerated = rtol > fast::Accuracy::best_rtol ? rtol * scale : 0;
  const double promised = std::max(quantity.promise * ulp_of(scale), tolerated);
  return {"fast", fmt::format("{}", value), upward_text(promised), false, static_cast<int>(-std::log10(rtol)),
          seconds};
}

Answer answer_of_seed(const Request& request) {
  const Point point = request.arguments.nearest(*request.quantity);
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
          seconds};
}

std::vector<Answer> answers_to(const Request& request) {
  std::vector<Answer> answers;
  if (request.form != nullptr) answers.push_back(answer_of_seed(request));
  if (request.by_ref) answers.push_back(answer_of_ref(request));
  if (request.by_fast) answers.push_back(answer_of_fast(request));
  return answers;
}

/// Text is what may not fit a double.
Json number_json(const Answer& answer, const std::string& text) {
  return answer.path == "ref" ? Json(text) : Json::number(text);
}

/// With the first answer: their values differ by less than what the scale is for.
Scale scale_of(const Request& request, const Answer& answer) try {
  const double size = std::max(std::fabs(std::strtod(answer.value.c_str(), nullptr)),
                               request.quantity->envelope(request.arguments.nearest(*request.quantity)));
  return {size, ulp_of(size)};
} catch (const BadInput&) {
  return {};
}

Json answer_json(const Answer& answer) {
  return {{"value", number_json(answer, answer.value)},
          {"error", answer.error ? number_json(answer, *answer.error) : Json()},
          {"proven", answer.proven},
          {"digits", answer.digits},
          {"times", {{"seconds", answer.seconds}}}};
}

Json to_json(const Request& request, const std::vector<Answer>& answers) {
  Json arguments = Json::object();
  for (std::size_t i = 0; i < request.arguments.text.size(); ++i)
    arguments.set(request.quantity->arguments[i].name, request.arguments.text[i]);
  const Scale scale = scale_of(request, answers.front());
  Json results = Json::object();
  for (const Answer& answer : answers) results.set(answer.path, answer_json(answer));
  return {{"quantity", request.quantity->name},
          {"arguments", arguments},
          {"scale", scale.size},
          {"ulp_of_scale", scale.ulp},
          {"caveat", request.by_fast ? Json(of_the_nearest_doubles) : Json()},
          {"results", results}};
}

void print_text(const Request& request, const std::vector<Answer>& answers, std::ostream& out) {
  out << fmt::format("{} = {}\n", request.quantity->name, request.quantity->definition);
  for (std::size_t i = 0; i < request.arguments.text.size(); ++i) {
    out << fmt::format("  {} = {}\n", request.quantity->arguments[i].name, request.arguments.text[i]);
  }
  for (const Answer& answer : answers) {
    out << fmt::format("{:4} ({} digits, {:.2g} s)\n  value        {}\n", answer.path, answer.digits,
                       answer.seconds, answer.value);
    if (answer.error)
      out << fmt::format("  {}  {}\n", answer.proven ? "error bound" : "estimated error", *answer.error);
  }
  const Scale scale = scale_of(request, answers.front());
  if (scale.size)
    out << fmt::format("scale          {} ({}); one ulp of it is {:.3g}\n", *scale.size,
                       request.quantity->scale, *scale.ulp);
  if (request.form != nullptr) out << fmt::format("not the quantity itself: {}\n", request.form->differs);
  if (request.by_fast) out << of_the_nearest_doubles << "\n";
}

}  // namespace

int eval_verb(const CommandLine& line, std::ostream& out) {
  const Request request = request_of(line);
  const std::vector<Answer> answers = answers_to(request);
  if (line.json) {
    out << answer_text("eval", to_json(request, answers), line.no_times);
  } else {
    print_text(request, answers, out);
  }
  return 0;
}

}  // namespace nipref::verify
