#pragma once
#include <vector>

#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/report/internal/markup.hpp>
#include <nipref/verify/report/internal/plots.hpp>
#include <nipref/verify/report/report.hpp>

namespace nipref::verify {

// The sections of the page, each with a heading whose id links lead to.

Markup comparison_section(const ReportComparison& comparison);  ///< #comparison
Markup headline_section(const Report& report);                  ///< #headline
Markup accuracy_section(const Report& report, Plots& plots);  ///< #accuracy, a quantity's row #accuracy-NAME
Markup speed_section(const Report& report, Plots& plots);     ///< #speed
Markup contacts_section(const Report& report);                ///< #contacts
Markup tables_section(const Report& report);                  ///< #tables, a table #ID
Markup figures_section(const std::vector<Figure>& figures, Plots& plots);  ///< #figures
Markup claims_section(const Report& report);                               ///< #claims
Markup limits_section(const Report& report);                               ///< #limits
Markup errata_section(const Report& report);                               ///< #errata
Markup hard_cases_section(const Report& report);                           ///< #hard-cases
Markup golden_section(const Report& report);                               ///< #golden
Markup reproduce_section(const Report& report);                            ///< #reproduce

/// A section with its heading.
Markup section(const std::string& id, const std::string& title, const Markup& content);

/// "kept" or "BROKEN", told by a mark, a word and a colour.
Markup verdict_mark(bool kept);

/// "met" or "MISSED", of a promised ratio.
Markup met_mark(bool met);

/// The page's style sheet.
extern const char* const style_sheet;

}  // namespace nipref::verify
