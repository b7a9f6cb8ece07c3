#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/report/internal/sections.hpp>

namespace nipref::verify {

Markup reproduce_section(const Report& report) {
  const std::string commands =
      report.command +
      "\n\n# parts of it, with all details\n"
      "nipref audit                # accuracy of every quantity; nipref audit NAME --points N\n"
      "nipref bench                # speed against error\n"
      "nipref audit contacts --seed " +
      report.seed +
      "\n"
      "nipref tables               # cell by cell\n"
      "nipref claims\nnipref limits\nnipref errata\nnipref golden check\n"
      "nipref figures thesis-17 --svg thesis-17.svg\n"
      "nipref report --against old/report.json   # what became better, worse, slower, new\n";
  return section(
      "reproduce", "How to reproduce this",
      element("pre", report.version) +
          element(
              "p",
              "From the top of the source tree, ./verify/run builds the program and makes this page. By hand:") +
          element("pre", commands) +
          element(
              "p",
              "Points of the audit are drawn from each quantity's name (sampler version " +
                  std::to_string(sampler_version) + ") and, as scenes, from the seed \"" + report.seed +
                  "\": errors are the same again, times are not. All numbers stand in report.json beside this page."));
}

}  // namespace nipref::verify
