#include <nipref/data/internal/common.hpp>
#include <nipref/data/scene/internal/rows.hpp>
#include <nipref/data/scene/results.hpp>

namespace nipref::data {
namespace {

constexpr std::string_view table_of_results =
#include <nipref_scene_results.inc>
    ;
constexpr std::string_view table_of_scales =
#include <nipref_scene_scales.inc>
    ;

// In the order of Shape and Needs.
constexpr std::array<std::string_view, 4> shapes{"number", "list", "profile", "field"};
constexpr std::array<std::string_view, 9> needs{
    "",      "converged",       "inside",       "inside-elastic", "inside-all",
    "shear", "line-load-creep", "partial-slip", "slip-heat"};

struct NamedScale {
  std::string_view name, text;
};

const std::vector<NamedScale>& scales() {
  static const std::vector<NamedScale> all = [] {
    std::vector<NamedScale> read;
    for (const auto& row : rows_of(table_of_scales, 2)) read.push_back({row[0], row[1]});
    return read;
  }();
  return all;
}

std::vector<SceneResult> read_results() {
  std::vector<SceneResult> all;
  for (const auto& row : rows_of(table_of_results, 7)) {
    SceneResult& result = all.emplace_back(static_cast<ResultId>(all.size()), row[0], row[1], row[6]);
    result.shape = named<Shape>(shapes, row[2]);
    if (!row[3].empty()) result.kind = named<SceneKind>(scene_kinds, row[3]);
    result.needs = named<Needs>(needs, row[4]);
    result.scale = named<Scale>(std::views::transform(scales(), &NamedScale::name), row[5]);
  }
  return all;
}

}  // namespace

std::string_view text(Scale scale) { return scales()[static_cast<std::size_t>(scale)].text; }

std::span<const SceneResult> scene_results() {
  static const std::vector<SceneResult> all = read_results();
  return all;
}

const SceneResult* find_scene_result(std::string_view name) {
  const auto all = scene_results();
  const auto found = std::ranges::find(all, name, &SceneResult::name);
  return found == all.end() ? nullptr : &*found;
}

const SceneResult& scene_result(ResultId id) { return scene_results()[static_cast<std::size_t>(id)]; }

}  // namespace nipref::data
