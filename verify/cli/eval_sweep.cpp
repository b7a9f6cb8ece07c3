#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include <nipref/verify/cli/eval_sweep.hpp>
#include <nipref/verify/cli/options.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>

namespace nipref::verify {
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
