#include <algorithm>
#include <complex>
#include <deque>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>
#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {
namespace {

using ComplexRow = Eigen::RowVectorXcd;

/// x - y in double, precise even if they are nearly equal. A null row counts as 0.
ComplexRow difference(const Row<ComplexFloat>* x, const Row<ComplexFloat>* y, GridIndex count) {
  const ComplexFloat zero;
  ComplexRow result(count);
  Float re, im;
  for (GridIndex i = 0; i < count; ++i) {
    const ComplexFloat &from = x != nullptr ? (*x)[i] : zero, &less = y != nullptr ? (*y)[i] : zero;
    mpfr_sub(raw(re), raw(from.re), raw(less.re), MPFR_RNDN);
    mpfr_sub(raw(im), raw(from.im), raw(less.im), MPFR_RNDN);
    result(i) = {static_cast<double>(re), static_cast<double>(im)};
  }
  return result;
}

void add_products(ComplexFloat& sum, const Row<ComplexFloat>& row, const Vector& values) {
  Float scratch;
  for (GridIndex i = 0; i < row.count(); ++i) {
    add_product(sum.re, scratch, row[i].re, values(i));
    if (!row[i].is_real()) add_product(sum.im, scratch, row[i].im, values(i));
  }
}

}  // namespace

SlipContact::SlipContact(std::shared_ptr<const ZoneGrid> grid, SheetKernels& kernels,
                         const Row<SlipZone>& zones)
    : grid_(std::move(grid)),
      zones_(zones),
      panels_(zones, *grid_),
      smooth_(panels_, *grid_, kernels),
      sources_{Row<Source>(panels_.values()), Row<Source>(panels_.values())},
      weights_(panels_.values()),
      values_{Vector(panels_.values()), Vector(panels_.values())} {
  count_unknowns();
  count_equations();
  add_conditions();
}

void SlipContact::count_unknowns() {
  const GridIndex nodes = grid_->nodes();
  const auto add = [&](const Float& size) -> Source {
    sizes_.push_back(size * problem().unit);
    return {sizes_.count() - 1};
  };
  auto& [pressures, shears] = sources_;
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    const auto& [sign, left, length, ratio, first] = panels_[number];
    for (GridIndex i = 0; i < nodes; ++i) {
      const Float size = sqrt(grid_->from_left()[i] * grid_->from_right()[i]);
      pressures[first + i] = add(size);
      shears[first + i] = sign == 0 ? add(size) : Source{pressures[first + i].column, ratio};
      weights_(first + i) = length * grid_->weight()[i];
    }
    weights_(first + nodes) = weights_(first + nodes + 1) = length / 2;
    if (number == 0) continue;
    const ZonePanel& before = panels_[number - 1];
    const Source value = add(1);
    pressures[first - 1] = pressures[first + nodes] = value;
    shears[first - 1] = shears[first + nodes] =
        sign == 0 && before.sign == 0 ? add(1) : Source{value.column, sign == 0 ? before.slip_ratio : ratio};
  }
  leading_column_ = add(1).column;
  if (!problem().creep) creep_column_ = add(1).column;
}

void SlipContact::count_equations() {
  const GridIndex last = grid_->nodes();
  for (GridIndex panel = 0; panel < panels_.count(); ++panel) {
    for (GridIndex i = 0; i <= last; ++i) {
      for (GridIndex part = 0; part < (panels_[panel].sign == 0 ? 2 : 1); ++part) {
        Equation equation{{panel, i}, std::nullopt, part, 0};
        const bool goes_on = panel > 0 && (part == 0 || panels_[panel - 1].sign == 0);
        if (2 * i != last)
          equation.less = {panel, 2 * i < last ? i + 1 : i - 1};
        else if (goes_on)
          equation.at = {panel, 0}, equation.less = {panel - 1, last};
        const PanelPoint& at = point(equation.at).at;
        equation.scale = 1 / sqrt(abs(at.from_left * at.from_right));
        equations_.push_back(std::move(equation));
      }
    }
  }
}

/// If slip is followed by stick, the coefficient of the power that slips the wrong way beyond the boundary is 0.
void SlipContact::add_conditions() {
  const OfBoth<Vector> none{Vector(panels_.values()), Vector(panels_.values())};
  for (GridIndex i = 1; i < panels_.count(); ++i) {
    const ZonePanel &before = panels_[i - 1], &after = panels_[i];
    if (before.sign == 0 || after.sign != 0) continue;
    const Float scale = pow(grid_->from_left()[0], Float(-Float(1) / 2 - problem().shift(before.sign)));
    conditions_.push_back({none, 0});
    conditions_.back().factors[shear_part](after.first) = scale;
    conditions_.back().factors[pressure_part](after.first) = -before.slip_ratio * scale;
  }
  const auto add_resultant = [&](std::size_t of, const Float& wanted) {
    conditions_.push_back({none, wanted / problem().unit});
    conditions_.back().factors[of] = weights_ / problem().unit;
  };
  if (problem().length)
    conditions_.push_back({none, *problem().length - panels_.length()});
  else
    add_resultant(pressure_part, problem().load);
  if (!problem().creep && !problem().may_stick_all_along(zones_)) add_resultant(shear_part, problem().shear);
}

void SlipContact::set(const Vector& unknowns) {
  leading_ = unknowns(leading_column_);
  creep_ = problem().creep ? *problem().creep : unknowns(creep_column_);
  for (std::size_t of : {pressure_part, shear_part}) {
    for (GridIndex i = 0; i < panels_.values(); ++i) {
      const auto& [column, factor] = sources_[of][i];
      if (column >= 0) values_[of](i) = factor * unknowns(column);
    }
  }
  smooth_.set(values_);
}

Vector SlipContact::unknowns_of(const SlipField& other) const {
  Vector unknowns(sizes_.count());
  const Float nearest = exp(Float(-other.contact().grid().nats()));
  const GridIndex nodes = grid_->nodes();
  for (const ZonePanel& panel : panels_) {
    const OfBoth<Float> at_left = other.tractions(panel.left),
                        at_right = other.tractions(panel.left + panel.length);
    const auto put = [&](GridIndex value, std::size_t of, const Float& traction) {
      const auto& [column, factor] = sources_[of][panel.first + value];
      if (column >= 0) unknowns(column) = traction / factor;
    };
    for (std::size_t of : {shear_part, pressure_part}) {
      put(nodes, of, at_left[of]);
      put(nodes + 1, of, at_right[of]);
    }
    for (GridIndex i = 0; i < nodes; ++i) {
      // Near an end the other grid is not precise: there the remainder is taken as the root of the distance.
      const Float &left = grid_->from_left()[i], &right = grid_->from_right()[i],
                  &distance = std::min(left, right), known = std::max(distance, nearest),
                  part = sqrt(distance / known);
      const Float from_left = left < right ? known : Float(1 - known);
      const OfBoth<Float> tractions = other.tractions(panel.left + panel.length * from_left);
      for (std::size_t of : {shear_part, pressure_part})
        put(i, of, part * (tractions[of] - (1 - from_left) * at_left[of] - from_left * at_right[of]));
    }
  }
  unknowns(leading_column_) = other.contact().leading();
  if (creep_column_ >= 0) unknowns(creep_column_) = other.contact().creep();
  return unknowns;
}

PointSums SlipContact::sums(const ContactPoint& point, bool with_tangential) const {
  auto [normal, tangential] = smooth_.at(panels_.place(point));
  panels_.set_cauchy_row(cauchy_, *grid_, point);
  const GridIndex left = panels_[point.panel].first + grid_->nodes();
  add_products(normal, cauchy_, values_[pressure_part]);
  if (with_tangential) add_products(tangential, cauchy_, values_[shear_part]);
  const auto linear = [&](std::size_t of) {
    return point.at.from_right * values_[of](left) + point.at.from_left * values_[of](left + 1);
  };
  return {normal + linear(shear_part) * problem().beta, tangential - linear(pressure_part) * problem().beta};
}

ContactPoint SlipContact::point(const PointIndex& index) const {
  return {index.panel, grid_->points(panels_[index.panel].sign)[index.point]};
}

ComplexFloat SlipContact::left_side(const ContactPoint& point) const {
  const auto [normal, tangential] = sums(point, sticks(point.panel));
  const ComplexFloat rest = normal + (panels_.place(point) - leading_) * Float(2);
  return sticks(point.panel) ? ComplexFloat(rest.re - tangential.im, rest.im + tangential.re - creep_) : rest;
}

Vector SlipContact::residual() const {
  Row<Row<ComplexFloat>> left_sides(panels_.count());
  for (GridIndex panel = 0; panel < panels_.count(); ++panel)
    for (GridIndex i = 0; i <= grid_->nodes(); ++i) left_sides[panel].push_back(left_side(point({panel, i})));
  Vector result(equations_.count() + conditions_.count());
  GridIndex row = 0;
  for (const auto& [at, less, part, scale] : equations_) {
    ComplexFloat value = left_sides[at.panel][at.point];
    if (less) value = value - left_sides[less->panel][less->point];
    result(row++) = (part == 0 ? value.re : value.im) * scale;
  }
  for (const auto& [factors, wanted] : conditions_) {
    result(row) = -wanted;
    for (std::size_t of : {pressure_part, shear_part})
      result(row) += factors[of].cwiseProduct(values_[of]).sum();
    ++row;
  }
  return result;
}

Row<ComplexFloat> SlipContact::point_row(const PointIndex& index) const {
  const ContactPoint here = point(index);
  Row<ComplexFloat> row;
  panels_.set_cauchy_row(row, *grid_, here);
  for (ComplexFloat& value : smooth_.lagrange(panels_.place(here))) row.push_back(std::move(value));
  row.push_back(here.at.from_right);
  row.push_back(here.at.from_left);
  return row;
}

Eigen::MatrixXd SlipContact::slopes() const {
  const auto [U, V, S] = smooth_.slopes();
  const auto beta = static_cast<double>(problem().beta);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(equations_.count() + conditions_.count(), sizes_.count());
  GridIndex number = 0;
  const auto add = [&](std::size_t of, const Eigen::VectorXd& slopes) {
    for (GridIndex i = 0; i < panels_.values(); ++i) {
      const auto& [column, factor] = sources_[of][i];
      if (column >= 0) matrix(number, column) += factor * slopes(i);
    }
  };
  // The parts of point_row().
  const GridIndex values = panels_.values(), points = U.rows();
  const auto cauchy_of = [=](const ComplexRow& row) { return row.head(values); };
  const auto lagrange_of = [=](const ComplexRow& row) { return row.segment(values, points); };
  const auto linear_of = [](const ComplexRow& row) { return row.tail(2); };
  // The rows of an equation are kept for the next ones.
  std::deque<std::pair<PointIndex, Row<ComplexFloat>>> rows;
  const auto row_at = [&](const PointIndex& index) -> const Row<ComplexFloat>* {
    const auto found = std::ranges::find(rows, index, [](const auto& known) { return known.first; });
    if (found != rows.end()) return &found->second;
    if (rows.size() == 3) rows.pop_front();
    return &rows.emplace_back(index, point_row(index)).second;
  };
  for (const auto& [at, less, part, scale] : equations_) {
    const Row<ComplexFloat>*here = row_at(at), *there = less ? row_at(*less) : nullptr;
    const auto in_double = static_cast<double>(scale);
    // The factors of the normal equation, and those of the tangential one, which enters with the factor i.
    const ComplexRow normal = in_double * difference(here, there, here->count());
    const ComplexRow tangential = std::complex<double>(0, in_double) *
                                  difference(sticks(at.panel) ? here : nullptr,
                                             less && sticks(less->panel) ? there : nullptr, here->count());
    OfBoth<ComplexRow> slopes{cauchy_of(normal), cauchy_of(tangential)};
    // Across a joint the other terms are continuous, and their difference is 0.
    if (!less || less->panel == at.panel) {
      const GridIndex ends = panels_[at.panel].first + grid_->nodes();
      slopes[pressure_part] += lagrange_of(normal) * U + lagrange_of(tangential) * V;
      slopes[shear_part] += lagrange_of(tangential) * S - lagrange_of(normal) * V;
      slopes[pressure_part].segment(ends, 2) -= beta * linear_of(tangential);
      slopes[shear_part].segment(ends, 2) += beta * linear_of(normal);
    }
    for (std::size_t of : {pressure_part, shear_part})
      add(of, part == 0 ? Eigen::VectorXd(slopes[of].real()) : Eigen::VectorXd(slopes[of].imag()));
    const GridIndex common = part == 0 ? leading_column_ : creep_column_;
    if (!less && common >= 0) matrix(number, common) = (part == 0 ? -2 : -1) * in_double;
    ++number;
  }
  for (const auto& [factors, wanted] : conditions_) {
    for (std::size_t of : {pressure_part, shear_part}) add(of, factors[of].cast<double>());
    ++number;
  }
  for (GridIndex i = 0; i < sizes_.count(); ++i) matrix.col(i) *= static_cast<double>(sizes_[i]);
  return matrix;
}

}  // namespace nipref::ref
