#include <algorithm>
#include <array>
#include <tuple>

#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/grade/fault.hpp>

namespace nipref::verify {
namespace {

constexpr auto fault_names = std::to_array<std::string_view>(
    {"crash", "exit", "hang", "refused", "not finite", "unwritten", "overrun", "arguments changed",
     "environment changed", "output", "order matters", "threads matter", "protocol", "given up"});
constexpr std::size_t shown = 4;

void widen(FaultGroup& group, const Point& point) {
  if (!group.lower) group.lower = group.upper = point;
  for (std::size_t i = 0; i < point.size(); ++i) {
    (*group.lower)[i] = std::min((*group.lower)[i], point[i]);
    (*group.upper)[i] = std::max((*group.upper)[i], point[i]);
  }
}

Json where_json(const Quantity& quantity, const std::optional<Point>& point) {
  return point ? point_json(quantity, *point) : Json();
}

}  // namespace

std::string_view name_of(FaultKind kind) { return fault_names[static_cast<std::size_t>(kind)]; }

std::vector<FaultGroup> grouped(std::vector<Fault> faults) {
  std::ranges::sort(faults, {},
                    [](const Fault& fault) { return std::tie(fault.kind, fault.point, fault.words); });
  std::vector<FaultGroup> groups;
  for (Fault& fault : faults) {
    if (groups.empty() || groups.back().kind != fault.kind) groups.push_back({fault.kind, 0, {}, {}, {}});
    FaultGroup& group = groups.back();
    ++group.count;
    if (fault.point) widen(group, *fault.point);
    if (group.first.size() < shown) group.first.push_back(std::move(fault));
  }
  return groups;
}

Json faults_json(const Quantity& quantity, const std::vector<Fault>& faults) {
  return json_list(grouped(faults), [&](const FaultGroup& group) {
    return Json{
        {"kind", name_of(group.kind)},
        {"count", group.count},
        {"lower", where_json(quantity, group.lower)},
        {"upper", where_json(quantity, group.upper)},
        {"first", json_list(group.first,
                            [&](const Fault& fault) {
                              return Json{{"at", where_json(quantity, fault.point)}, {"words", fault.words}};
                            })},
        {"_more", group.count > group.first.size() ? Json(group.count - group.first.size()) : Json()}};
  });
}

}  // namespace nipref::verify
