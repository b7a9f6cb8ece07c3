#include <iterator>
#include <sstream>

#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/figures/figures.hpp>
#include <nipref/verify/figures/internal/groups.hpp>

namespace nipref::verify {
namespace {

const Drawings& drawings() {
  static const Drawings all = [] {
    Drawings joined;
    for (auto* const part :
         {&kernel_drawings, &creep_range_drawing, &elastic_load_drawing, &elastic_profile_drawings,
          &moving_load_drawings, &rolling_drawings, &stress_drawing, &half_space_drawings})
      joined.merge(part());
    return joined;
  }();
  return all;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace

std::vector<FigurePlan> figures() {
  const data::CsvFile file = data::read_csv(data::statements_directory() / "figures.csv");
  std::vector<FigurePlan> all;
  for (std::size_t i = 1; i < file.records.size(); ++i) {
    const auto& record = file.records[i];
    if (record.size() != 6)
      data::refuse(file.path, record.front().position,
                   "must have id, title, parameters, drawing, of, tables");
    const auto drawing = drawings().find(record[3].text);
    if (drawing == drawings().end()) data::refuse(file.path, record[3].position, "must be a kind of figure");
    const FigureSubject subject{record[4].text, words_of(record[4].text), words_of(record[5].text)};
    all.push_back({record[0].text, record[1].text, record[2].text,
                   [panels = drawing->second, subject] { return panels(subject); }});
  }
  return all;
}

Figure compute(const FigurePlan& plan) { return {plan.id, plan.title, plan.parameters, plan.compute()}; }

}  // namespace nipref::verify
