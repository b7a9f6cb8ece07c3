#pragma once
#include <nipref/verify/figures/figure.hpp>
#include <nipref/verify/replay/replay.hpp>
#include <nipref/verify/seeds/internal/solved.hpp>
#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A row of data/statements/figures.csv, which describes a drawing.
struct FigureRow {
  std::vector<std::string> panels, of;
  std::string label;
  std::map<std::string, std::vector<std::string>> lists;
  std::vector<Replay> tables;

  /// The numbers of a list. "evenly A B N" and "ratios A B N" are N numbers from A to B with equal differences or equal
  /// ratios, "without A" removes A, and every other word is a number.
  [[nodiscard]] std::vector<double> numbers(const std::string& list) const;
};

/// The variables of a panel's or a curve's formulas and texts: the state of all loops around it.
struct FigureScope {
  const FigureRow* row;
  const TomlTable* shown = nullptr;  ///< the entry of the row's `of` that is shown
  const Replay* table = nullptr;     ///< the table of the loop over tables
  std::vector<std::pair<std::string, double>> numbers = {};
  std::vector<std::string> given = {};  ///< definitions, outer ones first
};

/// Contacts that several curves use.
struct FigureContacts {
  std::map<std::string, SolvedInDouble> scenes;
  SolvedNumbers others;
};

/// Evaluates the formulas of a scope. They have these terms besides those of StatementFormulas:
///   - [plain NAME x=X]: the thesis's sum of 500 residues for I1, I3, or the part of I6 that depends on alpha;
///     [plain Un], [plain Vn]: the sums for its solid under a moving load, keys t, T, t0 in half-thicknesses, memory;
///   - [nip NAME at=Y]: a result of the thesis's nip with the numbers B, load, memory, full_friction and accuracy;
///   - [scene ID METHOD NAME at=Y KEY=VALUE ...]: a result of a scene, or with ID "shown" of the scene that is shown,
///     by this method, with these values of its keys;
///   - [replayed COLUMN]: the replayed value of this column in the row of the entered cell.
class FigureFormulas {
 public:
  FigureFormulas(const FigureScope& scope, FigureContacts& contacts);

  double value(const std::string& formula) { return formulas_.value(formula).value(); }
  void define(const std::string& name, double number) { formulas_.define(name, Propagated::exact(number)); }
  /// The text with the fields that drawings.toml has in braces filled in.
  std::string text(const std::string& stated);
  /// The contact of the nip that the numbers B, load, memory, full_friction and accuracy describe.
  const SolvedContact<fast::Estimate>& nip();
  /// The table of the loop over tables; without such a loop all tables of the row.
  [[nodiscard]] std::span<const Replay> tables() const;
  /// From this call on formulas know the parameters of the cell's table, the row's `key`, the column's `coordinate`.
  void enter(const Replay& replay, const ReplayedCell& cell);

  const FigureScope& scope;

 private:
  Propagated solve(const std::string& words);
  void define_parameters(const data::Table& table);

  FigureContacts& contacts_;
  Formulas formulas_;
  const RowValues* replayed_ = nullptr;  ///< the replayed values of the entered cell's row
};

/// Draws a curve that no formula describes.
using DrawnSeries = std::vector<Series>(FigureFormulas& formulas, const Series& start);
/// The profile of the shown result by the thesis's line loads, at the loads or between them.
DrawnSeries by_line_loads;
/// The ranges of creep ratios that satisfy the thesis's conditions, for each number of the list m_beta.
DrawnSeries creep_ranges;
/// The slip zones of a nip with the load `load`, for each number of the list mu.
DrawnSeries slip_zones;

/// Lines of equal stress. The stress is divided by the largest pressure.
Contours stress_contours(FigureFormulas& formulas);

/// data/statements/drawings.toml
inline const TomlTable& drawings_file() { return statements_file("drawings.toml"); }

std::optional<Mark> mark_named(const std::string& name);

}  // namespace nipref::verify
