#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/axes.hpp>
#include <nipref/verify/catalogue/ulp.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/evaluation.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/support/internal/number_text.hpp>
#include <nipref/verify/support/json.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

namespace {

using data::BadInput;

/// What errors are measured against at the arguments, and its unit in the last place; none where doubles end.
struct Scale {
  std::optional<double> size, ulp;
};

/// With the first answer: their values differ by less than what the scale is for.
Scale scale_of(const EvalRequest& request, const ParsedArguments& arguments, const EvalAnswer& answer) try {
  const double size = std::max(std::fabs(std::strtod(answer.value.c_str(), nullptr)),
                               request.quantity->envelope(arguments.nearest(*request.quantity)));
  return {size, ulp_of(size)};
} catch (const BadInput&) {
  return {};
}

Json answer_json(const EvalAnswer& answer) {
  return {{"value", number_json(answer.path, answer.value)},
          {"error", answer.error ? number_json(answer.path, *answer.error) : Json()},
          {"proven", answer.proven},
          {"digits", answer.digits},
          {"met", answer.met},
          {"times", {{"seconds", answer.seconds}}}};
}

Json to_json(const EvalRequest& request, const ParsedArguments& arguments,
             const std::vector<EvalAnswer>& answers) {
  Json given = Json::object();
  for (const auto& [name, text] : written_arguments(*request.quantity, arguments.text)) given.set(name, text);
  const Scale scale = scale_of(request, arguments, answers.front());
  Json results = Json::object();
  for (const EvalAnswer& answer : answers) results.set(answer.path, answer_json(answer));
  return {{"quantity", request.quantity->name},
          {"arguments", given},
          {"scale", scale.size},
          {"ulp_of_scale", scale.ulp},
          {"caveat", caveat_json(request)},
          {"results", results}};
}

std::string answers_text(const EvalRequest& request, const ParsedArguments& arguments,
                         const std::vector<EvalAnswer>& answers) {
  std::string text = fmt::format("{} = {}\n", request.quantity->name, request.quantity->definition);
  for (const auto& [name, given] : written_arguments(*request.quantity, arguments.text))
    text += fmt::format("  {} = {}\n", name, given);
  for (const EvalAnswer& answer : answers) {
    text += fmt::format("{:4} ({} digits, {:.2g} s)\n  value        {}\n", answer.path, answer.digits,
                        answer.seconds, answer.value);
    if (answer.error)
      text += fmt::format("  {}  {}\n", answer.proven ? "error bound" : "estimated error", *answer.error);
    if (answer.met) text += fmt::format("  {}\n", met_text(answer.accuracy, *answer.met, " of the scale"));
  }
  const Scale scale = scale_of(request, arguments, answers.front());
  if (scale.size)
    text += fmt::format("scale          {} ({}); one ulp of it is {:.3g}\n", *scale.size,
                        request.quantity->scale, *scale.ulp);
  if (request.form != nullptr) text += fmt::format("not the quantity itself: {}\n", request.form->differs);
  if (const char* caveat = caveat_of(request)) text += std::string(caveat) + "\n";
  return folded(text);
}

}  // namespace

int eval_verb(const CommandLine& line, std::ostream& out) {
  const EvalRequest request = request_of(line);
  const Assignments given = with_material_numbers(*request.quantity, line.assignments);
  if (std::ranges::any_of(given, [](const auto& pair) { return is_swept(pair.second); }))
    return eval_sweep(request, line, out);
  refuse_option(line, "points", "has no effect without a range: must be left out");
  const ParsedArguments arguments = parse_arguments(*request.quantity, given);
  const std::vector<EvalAnswer> answers = answers_to(request, arguments);
  if (line.json) {
    out << answer_text("eval", to_json(request, arguments, answers), line.no_times);
  } else {
    out << answers_text(request, arguments, answers);
  }
  return std::ranges::any_of(answers, [](const EvalAnswer& answer) { return answer.met == false; }) ? 1 : 0;
}

namespace {

std::vector<Axis> axes_of(const CommandLine& line, const Assignments& given) {
  std::vector<Axis> axes;
  for (const auto& [name, text] : given) axes.push_back(axis_of(name, text, points_option(line)));
  return axes;
}

std::vector<std::string> paths_of(const EvalRequest& request) {
  if (request.form != nullptr) return {request.form->name};
  std::vector<std::string> paths;
  if (request.by_ref) paths.emplace_back("ref");
  if (request.by_fast) paths.emplace_back("fast");
  return paths;
}

std::vector<SweepColumn> columns_of(const EvalRequest& request) {
  std::vector<SweepColumn> columns;
  for (const std::string& path : paths_of(request)) {
    columns.push_back({path, path == "ref"});
    if (request.form == nullptr) columns.push_back({path + "_error", path == "ref"});
  }
  if (request.form == nullptr) columns.push_back({"missed", true});
  return columns;
}

SweepRow row_of(const EvalRequest& request, const ParsedArguments& arguments) {
  SweepRow row;
  std::vector<std::string> missed;
  for (EvalAnswer& answer : answers_to(request, arguments)) {
    row.cells.push_back(std::move(answer.value));
    if (answer.error) row.cells.push_back(std::move(*answer.error));
    if (answer.met == false) missed.push_back(answer.path);
  }
  if (request.form == nullptr) row.cells.push_back(fmt::format("{}", fmt::join(missed, " ")));
  row.fell_short = !missed.empty();
  return row;
}

}  // namespace

int eval_sweep(const EvalRequest& request, const CommandLine& line, std::ostream& out) {
  const Quantity& quantity = *request.quantity;
  const Assignments all = with_material_numbers(quantity, line.assignments);
  refuse_unknown_arguments(quantity, all);
  const AxesProduct points(axes_of(line, all));
  const Sweep sweep{"eval_sweep",
                    points,
                    columns_of(request),
                    {{"quantity", quantity.name}, {"caveat", caveat_json(request)}},
                    [&](std::size_t i) {
                      const Assignments given = points.assignments(i, &AxisValue::exact);
                      return row_of(request, parse_arguments(quantity, given));
                    }};
  return write_sweep(sweep, line, out);
}

}  // namespace nipref::verify
