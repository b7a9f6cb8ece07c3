#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <nipref/data/material/viscoelastic_models.hpp>
#include <nipref/verify/replay/internal/half_space.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/support/internal/parallel.hpp>

namespace nipref::verify {
namespace {

constexpr int residue_terms = 500;

constexpr std::array<ViscoelasticTable, 16> rolling_tables{{{"thesis-XI", 2, 24},
                                                            {"thesis-XII", 2, 24},
                                                            {"thesis-XIII", 2, 24},
                                                            {"thesis-XIV", 2, 24},
                                                            {"thesis-XV", 5, 24},
                                                            {"thesis-XVI", 5, 24},
                                                            {"thesis-XVII", 5, 24},
                                                            {"thesis-XVIII", 5, 24},
                                                            {"thesis-XIX", 5, 24},
                                                            {"thesis-XX", 5, 24},
                                                            {"thesis-XXI", 5, 24},
                                                            {"thesis-XXII", 5, 24},
                                                            {"thesis-XXIII", 10, 24},
                                                            {"thesis-XXIV", 10, 60},
                                                            {"thesis-XXV", 10, 60},
                                                            {"thesis-XXVI", 10, 60}}};

class ViscoelasticRowReplay {
 public:
  ViscoelasticRowReplay(const data::Table& table, std::size_t row, const ViscoelasticTable& how)
      : table_(table),
        row_(row),
        nip_(viscoelastic_nip_of_the_tables(table, row, false)),
        method_(viscoelastic_method(how)),
        input_(viscoelastic_row_input(table, row, nip_, method_)) {
    method_.trailing_elements = input_.trailing_elements;
    replayed_ = replay_viscoelastic_row(nip_, method_, input_.leading_length);
  }

  [[nodiscard]] ReplayedNip nip() const { return {replayed_.at_centre, input_.trailing_elements}; }

  [[nodiscard]] ReplayedCell cell(const std::string& column) const {
    const data::TableCell& cell = table_.cell(row_, column);
    const data::Interval range = replayed_.range(column);
    ReplayedCell result{row_, column, replayed_.at_centre.at(column), range, assess(cell, range), ""};
    if (column == input_.column) result.verdict = Verdict::input;
    if (input_.column.empty()) {
      result.verdict = Verdict::unexplained;
      result.note = "no length of the row is legible; this is at the table's load";
      return result;
    }
    if (result.verdict == Verdict::unexplained && column == "creep" &&
        assess(cell, replayed_.range(std::string(underflown_creep))) != Verdict::unexplained) {
      result.verdict = Verdict::seed_error;
      result.note = fmt::format(
          "the creep lacks the memory of the sign terms (AII.20) wherever e^(-lambda t) underflows on the "
          "thesis's machine: {:.6g}e-3 then",
          1e3 * replayed_.at_centre.at(std::string(underflown_creep)));
      return result;
    }
    result.note = note(result, cell);
    return result;
  }

 private:
  [[nodiscard]] std::string note(const ReplayedCell& replayed, const data::TableCell& cell) const {
    if (replayed.verdict == Verdict::input)
      return fmt::format("{} elements on the trailing side; {}", input_.trailing_elements,
                         load_note(replayed_.at_centre.at("W"), table_.parameter("W").value));
    return note_on(cell, replayed.verdict, [&] { return attempts(replayed); });
  }

  [[nodiscard]] std::string attempts(const ReplayedCell& missed) const {
    std::string text = one_digit(table_, missed.row, missed.column, missed.range);
    if (!text.empty()) text += "; ";
    return text + needed_length(missed) + "; " + other_elements(missed);
  }

  [[nodiscard]] std::string needed_length(const ReplayedCell& missed) const {
    const auto [low, high] = input_.leading_length;
    const double at_low = replayed_.corners.front().at(missed.column);
    const double at_high = replayed_.corners.back().at(missed.column);
    const double goal = table_.cell(row_, missed.column).number->value;
    return fmt::format("it would take L1 = {:.6g}e-3",
                       1e3 * (low + (goal - at_low) / (at_high - at_low) * (high - low)));
  }

  /// Whether one leading element more or less matches.
  [[nodiscard]] std::string other_elements(const ReplayedCell& missed) const {
    std::string met;
    fast::ViscoelasticLineLoadMethod other = method_;
    for (const int change : {-1, 0, 1}) {
      other.leading_elements = method_.leading_elements + change;
      for (other.trailing_elements = 1; other.trailing_elements <= other.leading_elements;
           ++other.trailing_elements) {
        const data::Interval range =
            replay_viscoelastic_row(nip_, other, input_.leading_length).range(missed.column);
        if (assess(table_.cell(row_, missed.column), range) != Verdict::unexplained)
          met += fmt::format(" {}+{}", other.leading_elements, other.trailing_elements);
      }
    }
    return met.empty() ? "no other numbers of elements near these meet it"
                       : "met by chance with elements:" + met;
  }

  const data::Table& table_;
  std::size_t row_;
  data::ViscoelasticNip nip_;
  fast::ViscoelasticLineLoadMethod method_;
  ViscoelasticRowInput input_;
  ReplayedRow replayed_;
};

}  // namespace

std::span<const ViscoelasticTable> viscoelastic_tables() { return rolling_tables; }

const ViscoelasticTable* find_viscoelastic_table(std::string_view id) {
  const auto* found = std::ranges::find(rolling_tables, id, &ViscoelasticTable::id);
  return found == rolling_tables.end() ? nullptr : found;
}

fast::ViscoelasticLineLoadMethod viscoelastic_method(const ViscoelasticTable& how) {
  return {how.leading_elements, how.leading_elements, how.approach, residue_terms};
}

double relaxation_length(const data::Table& table, std::size_t row) {
  return table.cell(row, "F0_tau").number->value;
}

data::ViscoelasticNip viscoelastic_nip_of_the_tables(const data::Table& table, std::size_t row,
                                                     bool as_defined) {
  const data::ElasticNip elastic = nip_of_the_tables(table);
  const double time = relaxation_length(table, row);  // at unit speed
  const data::Compliances at_once{elastic.material.theta1(), elastic.material.theta2()};
  return {elastic.roller_radius, elastic.sheet_thickness,
          as_defined ? data::single_relaxation_time_solid(at_once, time)
                     : data::misprinted_thesis_solid(at_once, time),
          1};
}

Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how) {
  const data::ElasticNip nip = nip_of_the_tables(table);
  Replay replay{
      std::move(table),
      fmt::format("line loads (7.6)-(7.17), {} elements on the leading side, {} residue terms, started {:g} "
                  "half-thicknesses before the nip, E = {:.6g} psi, poisson = {:g}, theta2 with e^(-2t/tau)",
                  how.leading_elements, residue_terms, how.approach, nip.material.young,
                  nip.material.poisson),
      {}};
  std::vector<std::vector<ReplayedCell>> rows(replay.table.rows.size());
  replay.nips.resize(rows.size());
  parallel_for(rows.size(), [&](std::size_t row) {
    const ViscoelasticRowReplay one(replay.table, row, how);
    replay.nips[row] = one.nip();
    for (const data::TableColumn& column : replay.table.columns) {
      if (!column.is_key) rows[row].push_back(one.cell(column.name));
    }
  });
  for (const auto& row : rows) replay.cells.insert(replay.cells.end(), row.begin(), row.end());
  return replay;
}

}  // namespace nipref::verify
