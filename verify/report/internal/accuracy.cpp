#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <nipref/verify/catalogue/arguments.hpp>
#include <nipref/verify/figures/render.hpp>
#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

constexpr std::size_t fewest_dots = 12;
constexpr double largest_linear_promise = 64;

const Argument& plotted_argument(const AuditResult& result) {
  return result.quantity->arguments[result.spread.along];
}

/// Where the dots lie on an axis; others have no place on a logarithmic one.
Series error_series(const std::string& label, Mark mark, const std::vector<ErrorDot>& dots, bool largest_only,
                    bool logarithmic) {
  Series series{label, label, mark, {}, {}};
  for (const ErrorDot& dot : dots) {
    if ((largest_only && !dot.largest) || (logarithmic && dot.ulps <= 0)) continue;
    series.x.push_back(dot.at);
    series.y.push_back(dot.ulps);
  }
  return series;
}

Series promise_series(const AuditResult& result) {
  const auto& dots = result.spread.dots;
  return {
      "promise", "promise", Mark::line, {dots.front().at, dots.back().at}, {result.promise, result.promise}};
}

/// The error of all points against one argument.
Panel error_panel(const AuditResult& result) {
  const Argument& argument = plotted_argument(result);
  const bool decades = spans_decades(argument.kind);
  const bool logarithmic = result.promise > largest_linear_promise || !result.kept();
  const auto& dots = result.spread.dots;
  Panel panel{{decades ? "|" + argument.name + "|" : argument.name, decades},
              {"error, ulp", logarithmic},
              {error_series("largest", Mark::line, dots, true, logarithmic),
               error_series("points", Mark::dots, dots, false, logarithmic), promise_series(result)}};
  if (std::isfinite(result.worst_ulp) && (!logarithmic || result.worst_ulp > 0))
    panel.series.push_back({"worst",
                            "worst",
                            Mark::star,
                            {place_on_axis(argument.kind, result.worst[result.spread.along])},
                            {result.worst_ulp}});
  return panel;
}

/// The arguments in a few decimals, for people.
std::string decimal_point(const Quantity& quantity, const Point& point) {
  std::string text;
  const auto few = [](double x) { return fmt::format("{:.6g}", x); };
  for (const auto& [name, value] : written_point(quantity, point, few))
    text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

/// What computes it again, by both paths, in words of the shell.
std::string command_for(const Quantity& quantity, const Point& point) {
  std::string text = "nipref eval " + quantity.name;
  const auto exact = [](double x) { return fmt::format("{:a}", x); };
  for (const auto& [name, value] : written_point(quantity, point, exact))
    text += value.ends_with(')') ? fmt::format(" '{}={}'", name, value) : fmt::format(" {}={}", name, value);
  return text;
}

Markup error_plot(const AuditResult& result, Plots& plots) {
  const Quantity& quantity = *result.quantity;
  const std::string instead = fmt::format(
      "Error of {} against {}: largest {:.3g} ulp at {}, promised are {:g} ulp.", quantity.name,
      plotted_argument(result).name, result.worst_ulp, decimal_point(quantity, result.worst), result.promise);
  return element("figure", plots.place(gnuplot_script(error_panel(result)), instead) +
                               element("figcaption", link_to("accuracy-" + quantity.name, quantity.name) +
                                                         ": " + quantity.definition));
}

Markup plots_of_subject(const std::string& subject, const std::vector<const AuditResult*>& results,
                        Plots& plots) {
  Markup grid;
  std::size_t drawn = 0;
  for (const AuditResult* result : results) {
    if (result->spread.dots.size() < fewest_dots) continue;
    grid += error_plot(*result, plots);
    ++drawn;
  }
  if (drawn == 0) return {};
  Attributes attributes{{"id", "plots-" + subject}};
  if (subject == "sheet") attributes.emplace_back("open", "open");
  return details(subject + Markup(" ") + element("span", {{"class", "soft"}}, fmt::format("{} plots", drawn)),
                 element("div", {{"class", "plots"}}, grid), attributes);
}

Markup all_plots(const std::vector<AuditResult>& results, Plots& plots) {
  std::vector<std::string> subjects;
  for (const AuditResult& result : results) {
    const std::string subject(result.quantity->subject);
    if (std::ranges::find(subjects, subject) == subjects.end()) subjects.push_back(subject);
  }
  Markup markup;
  for (const std::string& subject : subjects) {
    std::vector<const AuditResult*> of_subject;
    for (const AuditResult& result : results) {
      if (result.quantity->subject == subject) of_subject.push_back(&result);
    }
    markup += plots_of_subject(subject, of_subject, plots);
  }
  return markup;
}

Markup accuracy_table(const std::vector<AuditResult>& results) {
  TableMarkup table(
      "All quantities: the largest error found, in units in the last place of the scale (ulp)",
      {"quantity", "verdict", "#of its promise", "#largest, ulp", "#promise, ulp", "#median, ulp",
       "#99.9 %, ulp", "#points", "worst argument", "compute it again", "errors are measured against"});
  for (const AuditResult& result : results) {
    const Quantity& quantity = *result.quantity;
    table.row({{quantity.name, false, "keep"},
               {verdict_mark(result.kept()) + (result.few_points() ? ", few points" : ""), false, "keep"},
               number_cell(fmt::format("{:.0f} %", 100 * result.allowance_used)),
               number_cell(fmt::format("{:.4g}", result.max_error_ulp)),
               number_cell(fmt::format("{:g}", result.promise)),
               number_cell(fmt::format("{:.3g}", result.spread.median)),
               number_cell(fmt::format("{:.3g}", result.spread.percentile_999)),
               number_cell(std::to_string(result.points)),
               {decimal_point(quantity, result.worst), false, "wide"},
               {element("code", command_for(quantity, result.worst)), false, "wide"},
               {quantity.scale, false, "wide"}},
              "accuracy-" + quantity.name);
  }
  return table.markup();
}

}  // namespace

Markup accuracy_section(const Report& report, Plots& plots) {
  return section(
      "accuracy", "Accuracy: fast against the reference",
      element(
          "p",
          "The largest error found among so many points, by random points, hard cases and a search for the worst; it "
          "is no bound. The reference's own error is added to each. One ulp is the spacing of doubles at the scale "
          "that errors are measured against. Where fast states an error of its own for a value, that must cover too, and "
          "a share of the promise is a share of the smaller of the two.") +
          element(
              "p",
              "Dots: a sample of the points. Line: the largest error in each hundredth of the axis. Dashed: the "
              "promise. Star: the worst argument found.") +
          all_plots(report.quantities, plots) + accuracy_table(report.quantities));
}

}  // namespace nipref::verify
