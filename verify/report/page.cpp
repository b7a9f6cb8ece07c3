#include <array>
#include <utility>

#include <nipref/verify/report/internal/sections.hpp>
#include <nipref/verify/report/page.hpp>

namespace nipref::verify {
namespace {

Markup contents() {
  constexpr std::array<std::pair<const char*, const char*>, 12> entries{{{"headline", "At a glance"},
                                                                         {"accuracy", "Accuracy"},
                                                                         {"speed", "Speed"},
                                                                         {"contacts", "Contacts"},
                                                                         {"tables", "Tables"},
                                                                         {"figures", "Figures"},
                                                                         {"claims", "Claims"},
                                                                         {"limits", "Limits"},
                                                                         {"errata", "Errata"},
                                                                         {"hard-cases", "Hard cases"},
                                                                         {"golden", "Golden values"},
                                                                         {"reproduce", "Reproduce"}}};
  Markup items;
  for (const auto& [id, title] : entries) items += element("li", link_to(id, title));
  return element("nav", {{"aria-label", "Contents"}}, element("ul", items));
}

Markup head() {
  return element("head", empty_element("meta", {{"charset", "utf-8"}}) +
                             empty_element("meta", {{"name", "viewport"},
                                                    {"content", "width=device-width, initial-scale=1"}}) +
                             element("title", "nipref report") + element("style", Markup::raw(style_sheet)));
}

}  // namespace

Markup section(const std::string& id, const std::string& title, const Markup& content) {
  return element("section", {{"aria-labelledby", id}}, element("h2", {{"id", id}}, title) + content);
}

Markup verdict_mark(bool kept) {
  return kept ? element("span", {{"class", "good"}}, "\u2713 kept")
              : element("span", {{"class", "bad"}}, "\u2717 BROKEN");
}

Markup met_mark(bool met) {
  return met ? element("span", {{"class", "good"}}, "\u2713 met")
             : element("span", {{"class", "bad"}}, "\u2717 MISSED");
}

std::string report_page(const Report& report, const std::vector<Figure>& figures, const Drawer& draw) {
  Plots plots;
  const Markup compared = report.comparison ? comparison_section(*report.comparison) : Markup();
  const Markup main = compared + headline_section(report) + accuracy_section(report, plots) +
                      speed_section(report, plots) + contacts_section(report) + tables_section(report) +
                      figures_section(figures, plots) + claims_section(report) + limits_section(report) +
                      errata_section(report) + hard_cases_section(report) + golden_section(report) +
                      reproduce_section(report);
  const std::size_t first_line = report.version.find('\n');
  const std::string built =
      report.version.substr(0, first_line) + ", " +
      report.version.substr(first_line + 1, report.version.find('\n', first_line + 1) - first_line - 1);
  const Markup body =
      element("header", element("h1", "nipref: a verification reference for rolling contact") +
                            element("p", {{"class", "soft"}}, built)) +
      contents() + element("main", main);
  const std::string page =
      "<!DOCTYPE html>\n" + element("html", {{"lang", "en"}}, head() + element("body", body)).html();
  return plots.filled(page, draw);
}

}  // namespace nipref::verify
