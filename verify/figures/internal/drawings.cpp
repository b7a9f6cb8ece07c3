#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/support/internal/cache.hpp>
#include <nipref/verify/support/internal/parallel.hpp>
#include <nipref/verify/support/mapped.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {
FigureSubject::FigureSubject(const std::string& of, const std::string& numbers, const std::string& table_ids)
    : text(of), words(words_of(of)), tables(words_of(table_ids)) {
  for (const std::string& list : parts_of(numbers, ";")) {
    const auto parts = words_of(list);
    if (!parts.empty()) lists_[parts.front()] = {parts.begin() + 1, parts.end()};
  }
}

std::vector<double> FigureSubject::numbers(const std::string& name, double unit) const {
  const std::vector<std::string>& list = lists_.at(name);
  const auto number = [&](std::size_t i) { return unit * std::stod(list.at(i)); };
  std::vector<double> all;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i] == "evenly") {
      std::ranges::copy(evenly(number(i + 1), number(i + 2), std::stoi(list.at(i + 3))),
                        std::back_inserter(all));
      i += 3;
    } else if (list[i] == "ratios") {
      for (const double log :
           evenly(std::log10(number(i + 1)), std::log10(number(i + 2)), std::stoi(list.at(i + 3))))
        all.push_back(std::pow(10, log));
      i += 3;
    } else if (list[i] == "without") {
      std::erase(all, number(++i));
    } else {
      all.push_back(number(i));
    }
  }
  return all;
}

std::vector<Replay> FigureSubject::replays() const {
  static Cache<std::string, Replay> known;
  return mapped(tables, [](const auto& id) { return *known.at(id, [&] { return replay_table(id); }); });
}

std::vector<double> evenly(double first, double last, int count) {
  return mapped(std::views::iota(0, count), [&](int i) { return std::lerp(first, last, i / (count - 1.0)); });
}

Series sampled(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y) {
  auto values = mapped(x, y);
  return {std::move(label), std::move(role), mark, std::move(x), std::move(values)};
}

Series computed(std::string label, std::string role, Mark mark, std::vector<double> x, const Curve& y) {
  auto values = parallel_mapped(x.size(), [&](std::size_t i) { return y(x[i]); });
  return {std::move(label), std::move(role), mark, std::move(x), std::move(values)};
}

Series replayed_series(std::string label, std::string role, const std::vector<PlacedCell>& cells) {
  Series series{std::move(label), std::move(role), Mark::points, {}, {}};
  for (const PlacedCell& one : cells) {
    const auto cell = std::ranges::find_if(one.replay->cells, [&](const ReplayedCell& replayed) {
      return replayed.row == one.row && replayed.column == one.column;
    });
    series.x.push_back(one.replayed_at);
    series.y.push_back(one.replay->nips.empty() ? cell->value
                                                : one.replay->nips[one.row].values.at(one.column));
  }
  return series;
}

Series printed_series(std::string label, const std::vector<PlacedCell>& cells) {
  Series series{std::move(label), as_printed, Mark::bars, {}, {}};
  for (const PlacedCell& one : cells) {
    const data::TableCell& cell = one.replay->table.cell(one.row, one.column);
    if (!cell.is_printed() || !cell.is_readable() || cell.is_doubtful()) continue;
    series.x.push_back(one.printed_at);
    series.y.push_back(cell.number->value);
    series.low.push_back(cell.number->rounding.lower);
    series.high.push_back(cell.number->rounding.upper);
  }
  return series;
}

std::string axis_label(const std::string& quantity) {
  static const std::map<std::string, std::string> labels{
      {"p_max", "peak pressure p_max, psi"},
      {"L", "contact length L, in"},
      {"L/B", "contact length over thickness, L/B"},
      {"d0", "indentation d0, in"},
      {"d0/B", "indentation over thickness, d0/B"},
      {"creep", "creep ratio"},
      {"muR", "coefficient of rolling resistance mu_R"},
      {"pressure", "pressure p, psi"},
      {"shear", "shear on the sheet q, psi"},
      {"normal_displacement", "normal displacement u, in"},
      {"tangential_displacement", "tangential displacement v, in"}};
  return labels.at(quantity);
}

std::vector<FigurePlan> figures() {
  static const Drawings drawings = [] {
    Drawings joined;
    for (auto* const part : {&sheet_drawings, &nip_drawings, &half_space_drawings, &partial_slip_drawings})
      joined.merge(part());
    return joined;
  }();
  const data::CsvFile file = data::read_csv(data::statements_directory() / "figures.csv");
  std::vector<FigurePlan> all;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.size() != 7)
      data::refuse(file.path, record.front().position,
                   "must have id, title, parameters, drawing, of, numbers, tables");
    const auto drawing = drawings.find(record[3].text);
    if (drawing == drawings.end()) data::refuse(file.path, record[3].position, "must be a kind of figure");
    all.push_back(
        {record[0].text, record[1].text, record[2].text,
         [panels = drawing->second, subject = FigureSubject(record[4].text, record[5].text, record[6].text)] {
           return panels(subject);
         }});
  }
  return all;
}

Figure compute(const FigurePlan& plan) { return {plan.id, plan.title, plan.parameters, plan.compute()}; }

}  // namespace nipref::verify
