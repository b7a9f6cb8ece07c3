#include <nipref/verify/figures/render.hpp>
#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {
namespace {

Markup seed_figure(const Figure& figure, Plots& plots) {
  const std::string instead =
      figure.title + ". " + figure.parameters + ". Its numbers: nipref figures " + figure.id + " --csv FILE";
  return details(
      figure.id + Markup(" ") + element("span", {{"class", "soft"}}, figure.title),
      element(
          "figure", {{"class", "sheet"}},
          element("div",
                  {{"class", "scroll"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", figure.title}},
                  plots.place(gnuplot_script(figure), instead)) +
              element("figcaption", figure.parameters)));
}

}  // namespace

Markup figures_section(const std::vector<Figure>& figures, Plots& plots) {
  Markup all;
  for (const Figure& figure : figures) all += seed_figure(figure, plots);
  if (figures.empty()) all = element("p", "No figures were asked for.");
  return section(
      "figures", "Figures of the seeds, drawn again",
      element(
          "p",
          "Lines: what is true. Symbols: the seed's own method. Filled: what the seed printed, with its rounding.") +
          all);
}

}  // namespace nipref::verify
