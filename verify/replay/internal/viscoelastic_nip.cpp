#include <map>
#include <tuple>

#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/internal/readings.hpp>

namespace nipref::verify {
namespace {

constexpr int residue_terms = 500;

/// What one product loses at most on the IBM 360, whose single precision cuts after six hexadecimal digits.
constexpr double cut = 0x1p-20;

constexpr std::array<ViscoelasticTable, 16> rolling_tables{{{"thesis-XI", 2, 25},
                                                            {"thesis-XII", 2, 25},
                                                            {"thesis-XIII", 2, 25},
                                                            {"thesis-XIV", 2, 25},
                                                            {"thesis-XV", 5, 25},
                                                            {"thesis-XVI", 5, 25},
                                                            {"thesis-XVII", 5, 25},
                                                            {"thesis-XVIII", 5, 25},
                                                            {"thesis-XIX", 5, 25},
                                                            {"thesis-XX", 5, 25},
                                                            {"thesis-XXI", 5, 25},
                                                            {"thesis-XXII", 5, 25},
                                                            {"thesis-XXIII", 10, 25},
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
    result.note = note(result, cell);
    if (result.verdict == Verdict::unexplained) explain(result, cell);
    if (result.verdict == Verdict::unexplained || result.verdict == Verdict::misprint)
      judge_reading(table_, result, from(input_.agreed).range(column));
    if (result.verdict == Verdict::unexplained) judge_reading(table_, result, beyond().range(column));
    return result;
  }

 private:
  /// The row with so many elements, from that length: solved once for all columns that ask for it.
  [[nodiscard]] const ReplayedRow& with(const data::ViscoelasticLineLoads& method,
                                        const data::Interval& length) const {
    const auto [known, is_new] = rows_.try_emplace(
        {method.leading_elements, method.trailing_elements.value(), length.lower, length.upper});
    if (is_new) known->second = replay_viscoelastic_row(nip_, method, length);
    return known->second;
  }
  [[nodiscard]] const ReplayedRow& from(const data::Interval& length) const { return with(method_, length); }
  /// From a length that was cut to the printed one.
  [[nodiscard]] const ReplayedRow& beyond() const {
    const double end = input_.leading_length.upper;
    return from({end, end * (1 + cut)});
  }
  /// From what the narrowest printed length has beyond it.
  [[nodiscard]] const ReplayedRow& other() const {
    const double end = input_.leading_length.upper;
    return from({end, std::max(end, input_.narrowest.upper)});
  }

  /// Marks the cell as an error of the seed if what its machine lost meets it.
  void explain(ReplayedCell& replayed, const data::TableCell& cell) const {
    const std::string underflown(underflown_creep);
    const auto meets = [&](const ReplayedRow& row, const std::string& column) {
      return assess(cell, row.range(column)) != Verdict::unexplained;
    };
    if (replayed.column == "creep" && meets(replayed_, underflown)) {
      replayed.note = fmt::format(
          "the creep lacks the memory of the sign terms (AII.20) wherever e^(-lambda t) underflows on the "
          "thesis's machine: {:.6g}e-3 then",
          1e3 * replayed_.at_centre.at(underflown));
    } else if (meets(beyond(), replayed.column)) {
      replayed.note = fmt::format(
          "the printed {} is cut: met with one up to 16^-5 above what rounds to it, as much as one product "
          "loses in the single precision of the thesis's machine; {}",
          input_.column, replayed.note);
    } else if (meets(other(), replayed.column)) {
      replayed.note = fmt::format(
          "the printed {} is cut: met with a longer one, which the row's {} has, by which it is known more "
          "narrowly; {}",
          input_.column, input_.narrowest_column, replayed.note);
    } else {
      return;
    }
    replayed.verdict = Verdict::seed_error;
  }

  [[nodiscard]] std::string note(const ReplayedCell& replayed, const data::TableCell& cell) const {
    if (replayed.verdict == Verdict::input)
      return fmt::format("{} elements on the trailing side; {}", input_.trailing_elements,
                         load_note(replayed_.at_centre.at("W"), table_.parameter("W").value));
    return note_on(cell, replayed.verdict, [&] { return attempts(replayed); });
  }

  [[nodiscard]] std::string attempts(const ReplayedCell& missed) const {
    const double length =
        input_for(table_.cell(row_, missed.column).number->value, input_.leading_length,
                  replayed_.corners.front().at(missed.column), replayed_.corners.back().at(missed.column));
    return all_outcomes({one_digit(table_, missed.row, missed.column, missed.range),
                         fmt::format("it would take L1 = {:.6g}e-3", 1e3 * length), other_elements(missed)});
  }

  /// Whether one leading element more or less matches.
  [[nodiscard]] std::string other_elements(const ReplayedCell& missed) const {
    std::string met;
    data::ViscoelasticLineLoads other = method_;
    for (const int change : {-1, 0, 1}) {
      other.leading_elements = method_.leading_elements + change;
      for (int trailing = 1; trailing <= other.leading_elements; ++trailing) {
        other.trailing_elements = trailing;
        const data::Interval range = with(other, input_.leading_length).range(missed.column);
        if (assess(table_.cell(row_, missed.column), range) != Verdict::unexplained)
          met += fmt::format(" {}+{}", other.leading_elements, trailing);
      }
    }
    return met.empty() ? "no other numbers of elements near these meet it"
                       : "met by chance with elements:" + met;
  }

  const data::Table& table_;
  std::size_t row_;
  data::ViscoelasticNip nip_;
  data::ViscoelasticLineLoads method_;
  ViscoelasticRowInput input_;
  ReplayedRow replayed_;
  mutable std::map<std::tuple<int, int, double, double>, ReplayedRow> rows_;
};

}  // namespace

std::span<const ViscoelasticTable> viscoelastic_tables() { return rolling_tables; }

const ViscoelasticTable* find_viscoelastic_table(std::string_view id) {
  return item_with(rolling_tables, &ViscoelasticTable::id, id);
}

data::ViscoelasticLineLoads viscoelastic_method(const ViscoelasticTable& how) {
  return {how.leading_elements, how.leading_elements, how.approach, residue_terms, how.smallest_term};
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
          data::single_relaxation_time_solid(at_once, time, as_defined ? 1 : data::misprinted_rate_factor),
          1};
}

Replay replay_viscoelastic(data::Table table, const ViscoelasticTable& how) {
  const data::ElasticNip nip = nip_of_the_tables(table);
  Replay replay{
      std::move(table),
      fmt::format(
          "line loads (7.6)-(7.17), {} elements on the leading side, {} residue terms, in the last sum of "
          "(6.23) those up to the first below {:g} (gamma0 + gamma0'), started {:g} half-thicknesses "
          "before the nip, E = {:.6g} psi, poisson = {:g}, theta2 with e^(-2t/tau)",
          how.leading_elements, residue_terms, how.smallest_term, how.approach, nip.material.young,
          nip.material.poisson),
      {}};
  append_rows(replay, [&](std::size_t row) { return ViscoelasticRowReplay(replay.table, row, how); });
  return replay;
}

}  // namespace nipref::verify
