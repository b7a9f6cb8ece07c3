#include <filesystem>

#include <nipref/verify/audit/internal/sampling.hpp>
#include <nipref/verify/cli/sampling.hpp>
#include <nipref/verify/golden/golden.hpp>

namespace nipref::verify {

std::vector<Point> golden_points(const Quantity& quantity, const Ranges& ranges, std::size_t most) {
  const std::filesystem::path path = golden_path(quantity);
  if (!std::filesystem::exists(path)) return {};
  std::vector<Point> points;
  for (const GoldenRow& row : read_golden(path).rows) {
    if (contains(ranges, row.arguments)) points.push_back(row.arguments);
  }
  return thinned(std::move(points), most);
}

AuditOptions sampling_options(const CommandLine& line, const Quantity& quantity, double density) {
  AuditOptions options{points_option(line), {}, {}, density};
  options.seed = seed_option(line);
  if (!line.assignments.empty()) options.ranges = parse_ranges(quantity, line.assignments);
  options.more_points = golden_points(quantity, options.ranges, options.points_of(quantity) / golden_share);
  return options;
}

}  // namespace nipref::verify
