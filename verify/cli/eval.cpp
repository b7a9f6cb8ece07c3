#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/deviation.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/internal/stopwatch.hpp>

namespace nipref::verify {
namespace {

using data::BadInput;

/// The result of one path, as it is printed.
struct EvalAnswer {
  std::string path;  ///< ref, fast, or the name of the seed's form
  std::string value;
  double seconds;
  int digits;                             ///< for ref those requested, for fast those promised
  std::optional<std::string> error = {};  ///< nothing for the seed's forms
  bool proven = false;                    ///< whether the error is a proven bound
  long double accuracy = 0;               ///< requested: 10^-digits, or rtol
  std::optional<bool> met = {};  ///< nothing where no accuracy is requested; see catalogue/deviation.hpp
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

constexpr auto right_form = "corrected";

const Quantity& quantity_of(const CommandLine& line) {
  return find_quantity(line.words.empty() ? "(missing)" : line.words.front());
}

/// Refuses further words. If a word is a number, the message suggests the name of the quantity's first argument.
void refuse_more_words(const CommandLine& line) {
  if (line.words.size() < 2) return;
  const Quantity& quantity = quantity_of(line);
  const std::string& word = line.words[1];
  const bool is_number = std::string_view("+-.0123456789").find(word.front()) != std::string_view::npos;
  refuse("argument", word, "unexpected: eval takes one quantity and name=value pairs, as in 'eval {} {}={}'",
         quantity.name, quantity.arguments.front().name, is_number ? word : "...");
}

/// The form that is asked for; null for the corrected form.
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
  refuse("form", form, "must be {} of {}", fmt::join(known, " or "), quantity.name);
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
    refuse("digits", std::to_string(digits), "must be a whole number from 16 to {} for {}",
           quantity.most_digits, quantity.name);
  }
  return digits;
}

EvalAnswer answer_of_ref(const EvalRequest& request, const ParsedArguments& arguments) {
  const auto [found, seconds] =
      timed([&] { return request.quantity->by_ref(arguments.exact, request.digits); });
  return EvalAnswer("ref", found.value_text(), seconds, request.digits, found.error_text(), found.proven,
                    std::pow(10.0L, -request.digits),
                    is_met(*request.quantity, arguments, found, request.digits));
}

EvalAnswer answer_of_fast(const EvalRequest& request, const ParsedArguments& arguments) {
  const Quantity& quantity = *request.quantity;
  const Point point = arguments.nearest(quantity);
  const auto [value, seconds] = timed([&] { return quantity.by_fast(point, request.accuracy); });
  const double scale = std::max(std::fabs(value), quantity.envelope(point));
  const double rtol = request.accuracy.rtol();
  const double tolerated = rtol > fast::Accuracy::best_rtol ? rtol * scale : 0;
  const double promised = quantity.fast_error ? quantity.fast_error(point, request.accuracy)
                                              : std::max(quantity.promise * ulp_of(scale), tolerated);
  return EvalAnswer("fast", fmt::format("{}", value), seconds, static_cast<int>(-std::log10(rtol)),
                    upward_text(promised), false, rtol,
                    request.rtol_is_asked ? std::optional(is_met(promised, scale, rtol)) : std::nullopt);
}

EvalAnswer answer_of_seed(const EvalRequest& request, const ParsedArguments& arguments) {
  const Point point = arguments.nearest(*request.quantity);
  static_cast<void>(
      request.quantity->by_fast(point, request.accuracy));  // refuses arguments outside the domain
  const auto [value, seconds] = timed([&] { return request.form->value(point); });
  if (!std::isfinite(value))
    throw BadInput("form", request.form->name, "must be corrected here: the seed's form gives no number");
  return {request.form->name, fmt::format("{}", value), seconds, std::numeric_limits<double>::digits10};
}

EvalRequest request_of(const CommandLine& line) {
  const Quantity& quantity = quantity_of(line);
  const std::string path = line.option_or_usual("path");
  const SeedForm* form = form_of(line, quantity);
  refuse_options_without_effect(line, path, form);
  return EvalRequest(&quantity, form, form == nullptr && path != "fast", form == nullptr && path != "ref",
                     digits_for(quantity, line), accuracy_option(line), line.option("rtol").has_value());
}

std::string_view caveat_of(const EvalRequest& request) {
  if (request.quantity->ref_takes_doubles && request.form == nullptr)
    return "each argument is taken rounded to the nearest double; errors are for that argument.";
  return request.by_fast
             ? "fast takes each argument rounded to the nearest double; its error is for that argument."
             : "";
}

std::vector<EvalAnswer> answers_to(const EvalRequest& request, const ParsedArguments& arguments) {
  std::vector<EvalAnswer> answers;
  if (request.form != nullptr) answers.push_back(answer_of_seed(request, arguments));
  if (request.by_ref) answers.push_back(answer_of_ref(request, arguments));
  if (request.by_fast) answers.push_back(answer_of_fast(request, arguments));
  return answers;
}

/// ref's numbers are JSON text, as they may not fit a double.
Json number_json(const std::string& path, const std::string& text) {
  return path == "ref" ? Json(text) : Json::number(text);
}

/// The size against which errors at the arguments are measured; nothing where no double is near them. The first
/// answer's value is used, because the differences between the answers are too small to matter.
std::optional<double> scale_of(const EvalRequest& request, const ParsedArguments& arguments,
                               const EvalAnswer& answer) {
  return unless_refused([&] {
    return std::max(std::fabs(std::strtod(answer.value.c_str(), nullptr)),
                    request.quantity->envelope(arguments.nearest(*request.quantity)));
  });
}

Json answer_json(const EvalAnswer& answer) {
  return {{"value", number_json(answer.path, answer.value)},
          {"error", answer.error ? number_json(answer.path, *answer.error) : Json()},
          {"proven", answer.proven},
          {"digits", answer.digits},
          {"met", answer.met},
          {"times", {{"seconds", answer.seconds}}},
          // All digits that were computed, for the text.
          {"_value", answer.value},
          {"_error", answer.error},
          {"_accuracy", answer.met ? Json(fmt::format("{:g}", answer.accuracy)) : Json()}};
}

Json to_json(const EvalRequest& request, const ParsedArguments& arguments,
             const std::vector<EvalAnswer>& answers) {
  const auto scale = scale_of(request, arguments, answers.front());
  Json results = Json::object();
  for (const EvalAnswer& answer : answers) results.set(answer.path, answer_json(answer));
  return {{"quantity", request.quantity->name},
          {"arguments", json_object(written_arguments(*request.quantity, arguments.text))},
          {"scale", scale},
          {"ulp_of_scale", scale ? Json(ulp_of(*scale)) : Json()},
          {"caveat", Json::unless_empty(caveat_of(request))},
          {"results", results},
          {"_definition", request.quantity->definition},
          {"_scale", request.quantity->scale},
          {"_differs", request.form == nullptr ? Json() : Json(request.form->differs)}};
}

SweepRow row_of(const EvalRequest& request, const ParsedArguments& arguments) {
  SweepRow row;
  std::vector<std::string> missed;
  for (const auto& [path, value, seconds, digits, error, proven, accuracy, met] :
       answers_to(request, arguments)) {
    row.add(path, number_json(path, value), value);
    if (error) row.add(path + "_error", number_json(path, *error), *error);
    if (met == false) missed.push_back(path);
  }
  const std::string paths = fmt::format("{}", fmt::join(missed, " "));
  if (request.form == nullptr) row.add("missed", Json::unless_empty(paths), paths);
  row.fell_short = !missed.empty();
  return row;
}

/// The answer has a row for each combination, in order, with the names of the paths that missed the accuracy.
VerbAnswer eval_sweep(const EvalRequest& request, const CommandLine& line) {
  const Quantity& quantity = *request.quantity;
  const Assignments all = with_material_numbers(quantity, line.assignments);
  refuse_unknown_arguments(quantity, all);
  const AxesProduct points(
      mapped(all, [&](const auto& pair) { return axis_of(pair.first, pair.second, line.count("points")); }));
  const Sweep sweep{"eval_sweep",
                    points,
                    {{"quantity", quantity.name}, {"caveat", Json::unless_empty(caveat_of(request))}},
                    [&](std::size_t i) {
                      const Assignments given = points.assignments(i, &AxisValue::exact);
                      return row_of(request, parse_arguments(quantity, given));
                    }};
  return swept(sweep, line);
}

}  // namespace

VerbAnswer eval_verb(const CommandLine& line) {
  refuse_more_words(line);
  const EvalRequest request = request_of(line);
  const Assignments given = with_material_numbers(*request.quantity, line.assignments);
  if (std::ranges::any_of(given, [](const auto& pair) { return is_swept(pair.second); }))
    return eval_sweep(request, line);
  refuse_option(line, "points", "has no effect without a range: must be left out");
  const ParsedArguments arguments = parse_arguments(*request.quantity, given);
  const std::vector<EvalAnswer> answers = answers_to(request, arguments);
  const bool met = std::ranges::none_of(answers, [](const EvalAnswer& one) { return one.met == false; });
  return {"eval", to_json(request, arguments, answers), met};
}

}  // namespace nipref::verify
