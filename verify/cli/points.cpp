#include <fmt/format.h>

#include <cmath>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/command_line.hpp>
#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/sampling.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/grade/measured_points.hpp>

namespace nipref::verify {
namespace {

std::string command_text(const CommandLine& line) {
  std::string text = "command: nipref points " + line.words.front();
  for (const auto& [name, value] : line.assignments) text += fmt::format(" {}={}", name, value);
  for (const auto& [name, value] : line.options) text += fmt::format(" --{} {}", name, value);
  return text;
}

}  // namespace

int points_verb(const CommandLine& line, std::ostream& out) {
  const Quantity& quantity = find_quantity(line.words.empty() ? "(missing)" : line.words.front());
  AuditOptions options = sampling_options(line, quantity);
  options.search = false;
  options.points = options.points_of(quantity) - options.more_points.size();
  std::vector<Point> points = audit_points(quantity, options);
  std::erase_if(points, [&](const Point& point) { return std::isnan(fast_value(quantity, point, {})); });
  if (points.empty()) static_cast<void>(quantity.by_fast(audit_points(quantity, options).front(), {}));
  const std::string csv =
      points_csv(quantity, points,
                 {"quantity: " + quantity.name, command_text(line), "arguments: exact in hexadecimal"});
  return write_answer(line, out, "points", true, {{"quantity", quantity.name}, {"csv", csv}},
                      [&] { return csv; });
}

}  // namespace nipref::verify
