#include <fmt/format.h>

#include <algorithm>

#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/programs.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
namespace {

int list_figures(const std::vector<FigurePlan>& plans, const CommandLine& line, std::ostream& out) {
  if (line.json) {
    const Json list = json_list(plans, [](const FigurePlan& plan) {
      return Json{{"id", plan.id}, {"title", plan.title}, {"parameters", plan.parameters}};
    });
    out << answer_text("figures", {{"figures", list}}, line.no_times);
    return 0;
  }
  for (const FigurePlan& plan : plans)
    out << folded(fmt::format("{:<18} {}\n{:20}{}\n", plan.id, plan.title, "", plan.parameters));
  return 0;
}

std::string figure_svg(const Figure& figure, const std::string& file) {
  const auto drawn = drawn_by_gnuplot(gnuplot_script(figure_json(figure)));
  if (!drawn)
    throw data::BadInput("svg", file,
                         "must wait for the program gnuplot, which is not installed (Debian's gnuplot-nox)");
  return *drawn;
}

}  // namespace

int figures_verb(const CommandLine& line, std::ostream& out) {
  std::vector<FigurePlan> plans = figures();
  select_by_id(plans, line.words, "figure", &FigurePlan::id);
  const auto csv = line.option("csv"), svg = line.option("svg");
  if (line.has("list")) {
    if (csv || svg)
      throw data::BadInput("list", "(given)", "must be given without --csv and --svg: it draws nothing");
    return list_figures(plans, line, out);
  }
  if (line.words.empty())
    throw data::BadInput("figure", "(missing)", "must be one of those that --list shows");
  if (plans.size() > 1) throw data::BadInput("figure", line.words[1], "must be the only one");
  const Figure figure = compute(plans.front());
  const std::string drawing = svg ? figure_svg(figure, *svg) : "";
  if (csv) write_output_file(*csv, figure_csv(figure));
  if (svg) write_output_file(*svg, drawing);
  if (line.json) {
    out << answer_text("figures", {{"figure", figure_json(figure)}}, line.no_times);
  } else {
    out << (csv || svg ? folded(figure_text(figure)) : figure_csv(figure));
  }
  return 0;
}

}  // namespace nipref::verify
