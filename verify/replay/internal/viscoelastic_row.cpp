#include <nipref/fast/material/functions.hpp>
#include <nipref/verify/replay/internal/nip_tables.hpp>

namespace nipref::verify {
namespace {

/// A printed length. L1 follows from it for a given m2/m1.
struct PrintedLength {
  std::string column;
  data::Interval rounding;  ///< in
  bool is_doubtful;         ///< whether the row contradicts the length, or its reading rests on the replay

  [[nodiscard]] data::Interval leading(double ratio) const {
    return rounding.times(column == "L1" ? 1 : column == "L2" ? 1 / ratio : 1 / (1 + ratio));
  }
};

/// The printed lengths, the most reliable first.
std::vector<PrintedLength> printed_lengths(const data::Table& table, std::size_t row, double thickness) {
  std::vector<PrintedLength> lengths;
  for (const char* column : {"L1", "L", "L2", "L/B"}) {
    const data::TableCell& cell = table.cell(row, column);
    const bool is_ratio = column == std::string_view("L/B");
    if (cell.is_readable() && cell.is_printed())
      lengths.push_back({column, cell.number->rounding.times(is_ratio ? thickness : 1),
                         cell.is_doubtful() || cell.rests_on_replay()});
  }
  std::ranges::stable_partition(lengths, [](const PrintedLength& length) { return !length.is_doubtful; });
  return lengths;
}

/// The number of lengths whose interval for L1 intersects that of the first length.
std::size_t agreeing(const std::vector<PrintedLength>& lengths, double ratio) {
  const data::Interval first = lengths.front().leading(ratio);
  return static_cast<std::size_t>(std::ranges::count_if(
      lengths, [&](const PrintedLength& length) { return first.meets(length.leading(ratio)); }));
}

/// The part of the displacement v at the time t that is lost if e^(-rate t) underflows. It comes from the memory of the
/// sign terms of the loads, which pass at T_j: sum_j P_j/4 (amplitude/rate) [sign(T_j - t) - e^(-rate t)
/// + 2 H(t - T_j) e^(-rate (t - T_j))].
double underflown(const data::MaterialFunction& function, std::span<const fast::FaceLoad> loads, double t,
                  double first_T, double step) {
  constexpr double smallest = 180.2;
  double sum = 0;
  for (const data::RelaxationTerm& term : function.terms) {
    const double rate = term.rate.real();
    if (rate * t <= smallest) continue;
    double bracket = 0;
    for (std::size_t j = 0; j < loads.size(); ++j) {
      const double T = first_T + static_cast<double>(j) * step;
      bracket += loads[j].normal * (T > t ? 1 : 2 * std::exp(-rate * (t - T)) - 1);
    }
    sum += term.amplitude.real() / rate * bracket / 4;
  }
  return sum;
}

/// The lost part at the leading end minus that at the trailing end.
double underflown_memory(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                         const fast::LineLoadNip& loads) {
  const data::MaterialFunctions functions = fast::material_functions(nip.material);
  const double step = loads.element_width() / nip.speed;
  const double start = method.approach_lengths * nip.half_thickness() / nip.speed;
  const auto at = [&](double t) {
    return underflown(functions.theta1, loads.loads, t, start + step / 2, step) -
           underflown(functions.theta2, loads.loads, t, start + step / 2, step);
  };
  return at(start) - at(start + loads.contact_length() / nip.speed);
}

RowValues solved_rolling_row(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method,
                             double length) {
  const fast::LineLoadNip loads = fast::line_loads_for_length(nip, method, length);
  RowValues values = row_values(nip.sheet_thickness, loads);
  values[std::string(underflown_creep)] =
      values.at("creep") - underflown_memory(nip, method, loads) / values.at("L");
  return values;
}

/// The L1 for which the trailing end has the displacement d2. Uses the secant method from `guess`.
double length_with(const data::ViscoelasticNip& nip, const data::ViscoelasticLineLoads& method, double d2,
                   double guess) {
  const auto excess = [&](double length) {
    return fast::line_loads_for_length(nip, method, length).trailing_displacement() - d2;
  };
  double last = 1.01 * guess, at_last = excess(last), length = guess;
  for (int step = 0; step < 12; ++step) {
    const double here = excess(length);
    if (here == at_last) break;
    const double next = length - here * (length - last) / (here - at_last);
    last = length;
    at_last = here;
    length = next;
  }
  return length;
}

/// The input of a row without a legible length.
ViscoelasticRowInput without_length(const data::Table& table, std::size_t row,
                                    const data::ViscoelasticNip& nip, data::ViscoelasticLineLoads method) {
  const data::TableCell& d2 = table.cell(row, "d2");
  if (!d2.is_readable()) throw data::BadInput("d2", d2.printed, "or a length must be readable");
  method.trailing_elements.reset();
  const fast::LineLoadNip found = fast::line_loads_for_load(nip, method, table.parameter("W").value);
  method.trailing_elements = found.trailing_elements();
  const auto length = [&](double displacement) {
    return length_with(nip, method, displacement, found.leading_length);
  };
  const data::Interval leading{length(d2.number->rounding.lower), length(d2.number->rounding.upper)};
  return {"d2", leading, found.trailing_elements()};
}

/// L1 by d0 - d1 = L1^2/(2R); nothing if d0 or d1 is not legible or the row contradicts it.
std::optional<data::Interval> length_by_displacements(const data::Table& table, std::size_t row,
                                                      double roller_radius) {
  const data::TableCell &d0 = table.cell(row, "d0"), &d1 = table.cell(row, "d1");
  for (const data::TableCell* cell : {&d0, &d1})
    if (!cell->is_readable() || cell->is_doubtful()) return std::nullopt;
  const auto length = [&](double difference) { return std::sqrt(2 * roller_radius * difference); };
  return data::Interval{length(d0.number->rounding.lower - d1.number->rounding.upper),
                        length(d0.number->rounding.upper - d1.number->rounding.lower)};
}

/// Narrows the input's length by the row's other cells.
void narrow(ViscoelasticRowInput& input, const std::vector<PrintedLength>& lengths, double ratio,
            const std::optional<data::Interval>& by_displacements) {
  input.narrowest_column = input.column;
  for (const PrintedLength& length : lengths) {
    const data::Interval leading = length.leading(ratio);
    if (length.is_doubtful || !leading.meets(input.leading_length)) continue;
    input.agreed = input.agreed.within(leading);
    if (leading.width() >= input.narrowest.width()) continue;
    input.narrowest_column = length.column;
    input.narrowest = leading;
  }
  if (by_displacements) input.agreed = input.agreed.within(*by_displacements);
}

}  // namespace

ViscoelasticRowInput viscoelastic_row_input(const data::Table& table, std::size_t row,
                                            const data::ViscoelasticNip& nip,
                                            data::ViscoelasticLineLoads method) {
  const auto lengths = printed_lengths(table, row, nip.sheet_thickness);
  if (lengths.empty()) return without_length(table, row, nip, method);
  const auto presses = [&](const ViscoelasticRowInput& input) {
    method.trailing_elements = input.trailing_elements;
    return fast::line_loads_for_length(nip, method, input.leading_length.middle()).presses_everywhere();
  };
  std::optional<ViscoelasticRowInput> best;
  std::size_t most = 0;
  for (int trailing = method.leading_elements; trailing > 0; --trailing) {
    const double ratio = static_cast<double>(trailing) / method.leading_elements;
    const std::size_t agree = agreeing(lengths, ratio);
    const ViscoelasticRowInput input{lengths.front().column, lengths.front().leading(ratio), trailing};
    // If as many lengths agree with several inputs, the first input without tension is best, or else the first input.
    if (agree > most || (agree == most && !presses(*best) && presses(input))) best = input;
    most = std::max(most, agree);
  }
  narrow(*best, lengths, static_cast<double>(best->trailing_elements) / method.leading_elements,
         length_by_displacements(table, row, nip.roller_radius));
  return *best;
}

ReplayedRow replay_viscoelastic_row(const data::ViscoelasticNip& nip,
                                    const data::ViscoelasticLineLoads& method,
                                    const data::Interval& leading_length) {
  return replay_row({leading_length},
                    [&](const auto& inputs) { return solved_rolling_row(nip, method, inputs.front()); });
}

}  // namespace nipref::verify
