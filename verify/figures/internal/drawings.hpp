#pragma once
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// What a row of data/statements/figures.csv says about a drawing.
struct FigureRow {
  std::vector<std::string> panels, of;
  std::string label;
  std::map<std::string, std::vector<std::string>> lists;
  std::vector<Replay> tables;

  /// The numbers of a list: "evenly A B N" and "ratios A B N" are N numbers from A to B, "without A" leaves one out, all
  /// other words are numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& list) const;
};

/// What the formulas and texts of a panel or a curve refer to: the round of each loop around it.
struct FigureScope {
  const FigureRow* row;
  const TomlTable* shown = nullptr;  ///< what is shown, of the row's `of`
  const Replay* table = nullptr;     ///< of the loop over tables
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<std::string> given = {};  ///< definitions, the outer ones first
};

/// Contacts that curves share.
struct FigureContacts {
  std::map<std::string, SolvedInDouble> scenes;
  SolvedNumbers others;
};

/// Evaluates the formulas of a scope. Besides what StatementFormulas describes they have
///   - [plain NAME x=X]: the thesis's sum of 500 residues for I1, I3, or the part of I6 that depends on alpha; [plain Un] and
///     [plain Vn] those of its solid under a moving load, keys t, T, t0 in half-thicknesses b, and memory;
///   - [nip NAME at=Y]: a result of the thesis's nip with the numbers B, load, memory, grips and accuracy;
///   - [scene ID METHOD NAME at=Y KEY=VALUE ...]: a result of a scene, or of that of what is "shown", by that method, with values
///     of its keys;
///   - [replayed COLUMN]: in the row of the cell that is drawn.
class FigureFormulas {
 public:
  FigureFormulas(const FigureScope& scope, FigureContacts& contacts);

  double value(const std::string& formula) { return formulas_.value(formula).value(); }
  void define(const std::string& name, double number) { formulas_.define(name, Propagated::exact(number)); }
  /// With what drawings.toml has between braces.
  std::string text(const std::string& stated);
  /// The contact of the nip that is described by its numbers.
  const SolvedContact<fast::Estimate>& nip();
  /// That of the loop over tables, otherwise all of the row.
  [[nodiscard]] std::span<const Replay> tables() const;
  /// From here on formulas know the cell's table, `key` of its row, and `coordinate` of its column.
  void enter(const Replay& replay, const ReplayedCell& cell);

  const FigureScope& scope;

 private:
  Propagated solve(const std::string& words);
  void define_parameters(const data::Table& table);

  FigureContacts& contacts_;
  Formulas formulas_;
  const RowValues* replayed_ = nullptr;  ///< in the row of the cell that was entered
};

/// A curve that no formula describes.
using DrawnSeries = std::vector<Series>(FigureFormulas& formulas, const Series& start);
/// The profile of the result that is shown by the thesis's line loads, at the loads or between them.
DrawnSeries by_line_loads;
/// The ranges of creep ratios that the thesis's conditions leave, for the list m_beta.
DrawnSeries creep_ranges;
/// The zones in which a nip with the load `load` slips, for the list mu.
DrawnSeries slip_zones;

/// Lines of equal stress over the largest pressure.
Contours stress_contours(FigureFormulas& formulas);

/// data/statements/drawings.toml
inline const TomlTable& drawings_file() { return statements_file("drawings.toml"); }

std::optional<Mark> mark_named(const std::string& name);

}  // namespace nipref::verify
