#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/audit_run.hpp>
#include <nipref/verify/cli/sweep_rows.hpp>
#include <nipref/verify/cli/verbs.hpp>
#include <nipref/verify/golden/contacts.hpp>
#include <nipref/verify/golden/golden.hpp>
#include <nipref/verify/grade/measured_points.hpp>

namespace nipref::verify {

/// At most one in `golden_share` of the points is a golden point.
constexpr std::size_t golden_share = 10;

std::vector<Point> golden_points(const Quantity& quantity, const Ranges& ranges, std::size_t most) {
  const std::filesystem::path path = golden_path(quantity.name);
  if (!std::filesystem::exists(path)) return {};
  std::vector<Point> points;
  for (const GoldenRow& row : read_golden(path).rows)
    if (contains(ranges, row.arguments)) points.push_back(row.arguments);
  return thinned(std::move(points), most);
}

AuditOptions sampling_options(const CommandLine& line, const Quantity& quantity, double density) {
  AuditOptions options{line.count("points"), {}, {}, density};
  options.seed = line.option_or_usual("seed");
  if (!line.assignments.empty()) options.ranges = parse_ranges(quantity, line.assignments);
  options.more_points = golden_points(quantity, options.ranges, options.points_of(quantity) / golden_share);
  return options;
}

VerbAnswer points_verb(const CommandLine& line) {
  const std::string name = line.words.empty() ? "(missing)" : line.words.front();
  const auto answer = [&](const Quantity& quantity, const std::vector<Point>& points) {
    const std::string csv = points_csv(
        quantity, points,
        {"quantity: " + name, fmt::format("command: nipref {}", fmt::join(words_of(line, {"json"}), " ")),
         "arguments: exact in hexadecimal; NAME_decimal is read as the same double"});
    return VerbAnswer{"points", {{"quantity", name}, {"csv", csv}}, true, [=] { return csv; }};
  };
  if (is_contact_kind(name))
    return answer(contact_quantities(name).front(),
                  contact_points(name, swept_scenes(contact_scene(name), line)));
  const Quantity& quantity = find_quantity(name);
  AuditOptions options = sampling_options(line, quantity);
  options.search = false;
  options.points = options.points_of(quantity) - options.more_points.size();
  std::vector<Point> points = audit_points(quantity, options);
  std::erase_if(points, [&](const Point& point) { return std::isnan(fast_value(quantity, point, {})); });
  if (points.empty()) static_cast<void>(quantity.by_fast(audit_points(quantity, options).front(), {}));
  return answer(quantity, points);
}

}  // namespace nipref::verify
