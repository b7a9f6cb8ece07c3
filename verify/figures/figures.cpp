#include <nipref/data/directory.hpp>
#include <nipref/data/table/csv.hpp>
#include <nipref/verify/figures/internal/drawings.hpp>

namespace nipref::verify {

std::vector<FigurePlan> figures() {
  static const Drawings drawings = [] {
    Drawings joined;
    for (auto* const part : {&sheet_drawings, &nip_drawings, &profile_drawings, &half_space_drawings})
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
