#include <nipref/data/material/viscoelastic.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>
#include <nipref/verify/replay/internal/readings.hpp>

namespace nipref::verify {
namespace {

constexpr int residue_terms = 500;

/// The largest relative loss of one product on the IBM 360, whose single precision cuts after six hexadecimal digits.
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

/// A row of a table of the viscoelastic nip. Its input is L1.
class ViscoelasticRow final : public NipRow {
 public:
  ViscoelasticRow(const data::Table& table, std::size_t row, const ViscoelasticTable& how)
      : NipRow(table, row),
        nip_(viscoelastic_nip_of_the_tables(table, row, false)),
        method_(viscoelastic_method(how)),
        input_(viscoelastic_row_input(table, row, nip_, method_)) {
    begin({how.leading_elements, input_.trailing_elements}, input_.leading_length);
    const double end = length_.upper;
    beyond_ = {end, end * (1 + cut)};
    other_ = {end, std::max(end, input_.narrowest.upper)};
    other_lengths_ = {input_.agreed, beyond_};
    inputs_[input_.column] = fmt::format("{} elements on the trailing side; {}", input_.trailing_elements,
                                         load_note(replayed_.at_centre.at("W"), table_.parameter("W").value));
  }

 private:
  [[nodiscard]] ReplayedRow replay(const Elements& elements, const data::Interval& length) const override {
    data::ViscoelasticLineLoads method = method_;
    method.leading_elements = elements.leading;
    method.trailing_elements = elements.trailing;
    return replay_viscoelastic_row(nip_, method, length);
  }

  /// Explains the cell by a loss of digits on the thesis's machine, if one meets it.
  void explain(ReplayedCell& missed) const override {
    const auto meets = [&](const ReplayedRow& row, std::string_view column) {
      return assess(printed(missed.column), row.range(std::string(column))) != Verdict::unexplained;
    };
    if (missed.column == "creep" && meets(replayed_, underflown_creep)) {
      missed.note = fmt::format(
          "the creep lacks the memory of the sign terms (AII.20) wherever e^(-lambda t) underflows on the "
          "thesis's machine: {:.6g}e-3 then",
          1e3 * replayed_.at_centre.at(std::string(underflown_creep)));
    } else if (meets(with(elements_, beyond_), missed.column)) {
      missed.note = fmt::format(
          "the printed {} is cut: met with one up to 16^-5 above what rounds to it, as much as one product "
          "loses in the single precision of the thesis's machine; {}",
          input_.column, missed.note);
    } else if (meets(with(elements_, other_), missed.column)) {
      missed.note = fmt::format(
          "the printed {} is cut: met with a longer one, which the row's {} has, by which it is known more "
          "narrowly; {}",
          input_.column, input_.narrowest_column, missed.note);
    } else {
      return;
    }
    missed.verdict = Verdict::seed_error;
  }

  [[nodiscard]] std::string attempts(const ReplayedCell& missed) const override {
    const double length =
        input_for(printed(missed.column).number->value, length_, replayed_.corners.front().at(missed.column),
                  replayed_.corners.back().at(missed.column));
    return all_outcomes({one_digit(table_, row_, missed.column, missed.range),
                         fmt::format("it would take L1 = {:.6g}e-3", 1e3 * length), other_elements(missed)});
  }

  /// The numbers of elements, with at most one leading element more or less, that give the printed number; in words.
  [[nodiscard]] std::string other_elements(const ReplayedCell& missed) const {
    std::vector<Elements> tried;
    for (const int leading : {elements_.leading - 1, elements_.leading, elements_.leading + 1})
      for (int trailing = 1; trailing <= leading; ++trailing) tried.push_back({leading, trailing});
    std::string met;
    for (const auto& [leading, trailing] : meeting(missed, tried))
      met += fmt::format(" {}+{}", leading, trailing);
    return met.empty() ? "no other numbers of elements near these meet it"
                       : "met by chance with elements:" + met;
  }

  data::ViscoelasticNip nip_;
  data::ViscoelasticLineLoads method_;
  ViscoelasticRowInput input_;
  data::Interval beyond_{};  ///< the lengths that a cut turns into the printed one
  data::Interval other_{};   ///< the longer lengths that the narrowest printed length still admits
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
  append_rows(replay,
              [&](std::size_t row) { return std::make_unique<ViscoelasticRow>(replay.table, row, how); });
  return replay;
}

}  // namespace nipref::verify
