#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_contact.hpp>
#include <nipref/ref/partial_slip/internal/slip_field.hpp>

namespace nipref::ref {
namespace {

using Complex = std::complex<double>;

Complex in_double(const ComplexFloat& x) { return {static_cast<double>(x.re), static_cast<double>(x.im)}; }

/// Points whose interpolation of kernels with poles at the height 2 is good to e^-nats, even so that 1/2 is none.
int points_for(double length, double nats) {
  const double height = 4 / length;
  return 2 * static_cast<int>(std::ceil((nats / std::asinh(height) + 2) / 2));
}

ComplexFloat reciprocal(const ComplexFloat& x) {
  if (x.is_real()) return 1 / x.re;
  const Float square = x.re * x.re + x.im * x.im;
  return {x.re / square, -x.im / square};
}

/// value = weight/x in place, as this is most of the work.
void set_quotient(ComplexFloat& value, const Float& weight, const ComplexFloat& x, ComplexFloat& scratch) {
  if (x.is_real()) {
    mpfr_div(raw(value.re), raw(weight), raw(x.re), MPFR_RNDN);
    mpfr_set_zero(raw(value.im), 1);
    return;
  }
  mpfr_sqr(raw(scratch.re), raw(x.re), MPFR_RNDN);
  mpfr_sqr(raw(scratch.im), raw(x.im), MPFR_RNDN);
  mpfr_add(raw(scratch.re), raw(scratch.re), raw(scratch.im), MPFR_RNDN);
  mpfr_div(raw(scratch.im), raw(weight), raw(scratch.re), MPFR_RNDN);
  mpfr_mul(raw(value.re), raw(scratch.im), raw(x.re), MPFR_RNDN);
  mpfr_mul(raw(value.im), raw(scratch.im), raw(x.im), MPFR_RNDN);
  mpfr_neg(raw(value.im), raw(value.im), MPFR_RNDN);
}

}  // namespace

Row<PanelPoint> extreme_points(int count) {
  Row<PanelPoint> points;
  for (GridIndex i = 0; i < count; ++i) {
    const Float angle = pi() * i / (2 * (count - 1)), other = pi() * (count - 1 - i) / (2 * (count - 1));
    const Float left = sin(angle), right = sin(other);
    points.push_back({Float(left * left), Float(right * right)});
  }
  return points;
}

Row<ComplexFloat> lagrange(const Row<PanelPoint>& points, const PanelPoint& x) {
  Row<ComplexFloat> values;
  ComplexFloat sum;
  for (GridIndex i = 0; i < points.count(); ++i) {
    const bool is_left = 2 * i < points.count();
    const ComplexFloat way =
        is_left ? x.from_left - points[i].from_left : points[i].from_right - x.from_right;
    const Float weight = (i % 2 == 0 ? 1 : -1) * (i == 0 || i + 1 == points.count() ? Float(0.5) : Float(1));
    values.push_back(reciprocal(way) * weight);
    sum = sum + values.back();
  }
  sum = reciprocal(sum);
  for (ComplexFloat& value : values) value = value * sum;
  return values;
}

SlipContact::SlipContact(const SlipProblem& problem, std::shared_ptr<const ZoneGrid> grid,
                         SheetKernels& kernels, Row<SlipZone> zones)
    : problem_(problem), grid_(std::move(grid)), kernels_(kernels), zones_(std::move(zones)) {
  divide();
  count_unknowns();
  make_smooth_kernels();
}

void SlipContact::divide() {
  Float left = 0;
  for (GridIndex zone = 0; zone < zones_.count(); ++zone) {
    const int parts =
        std::max(1, static_cast<int>(std::ceil(static_cast<double>(zones_[zone].length) / longest_panel)));
    const Float length = zones_[zone].length / parts;
    const Row<PanelPoint> points = extreme_points(points_for(static_cast<double>(length), grid_->nats()));
    for (int part = 0; part < parts; ++part) {
      Panel panel{zone, zones_[zone].sign, left, length, places_.count(), points, {}, {}, {}};
      for (const PanelPoint& point : points) places_.push_back(left + length * point.from_left.re);
      left += length;
      panels_.push_back(std::move(panel));
    }
  }
}

void SlipContact::count_unknowns() {
  const GridIndex nodes = grid_->nodes();
  for (Panel& panel : panels_) {
    for (std::size_t of : {pressure_part, shear_part}) {
      panel.values[of].grow(nodes + 2);
      panel.sources[of].grow(nodes + 2);
      const bool is_own = of == pressure_part || panel.sign == 0;
      for (GridIndex i = 0; i < nodes; ++i)
        panel.sources[of][i] =
            is_own ? Source{columns_++}
                   : Source{panel.sources[pressure_part][i].column, panel.sign * problem_.friction};
    }
  }
  for (GridIndex right = 1; right < panels_.count(); ++right) {
    Panel &before = panels_[right - 1], &after = panels_[right];
    const Source value{columns_++};
    const int sign = before.sign + after.sign;
    const Source sheared =
        before.zone == after.zone && sign == 0
            ? Source{columns_++}
            : Source{value.column, (before.zone == after.zone ? before.sign : sign) * problem_.friction};
    before.sources[pressure_part][nodes + 1] = after.sources[pressure_part][nodes] = value;
    before.sources[shear_part][nodes + 1] = after.sources[shear_part][nodes] = sheared;
  }
  sizes_.grow(columns_ + 2);
  std::ranges::fill(sizes_, Float(1));
  for (const Panel& panel : panels_)
    for (std::size_t of : {pressure_part, shear_part})
      for (GridIndex i = 0; i < nodes; ++i)
        sizes_[panel.sources[of][i].column] = sqrt(grid_->from_left()[i] * grid_->from_right()[i]);
  leading_column_ = columns_++;
  if (!problem_.creep) creep_column_ = columns_++;
}

void SlipContact::make_smooth_kernels() {
  const auto count = places_.count();
  for (Matrix& kernel : smooth_) kernel = Matrix(count, count);
  const Float over_pi = 1 / pi();
  for (const Float& weight : grid_->weight()) {
    weights_.push_back(over_pi * weight);
    minus_weights_.push_back(-weights_.back());
  }
  for (GridIndex i = 0; i < count; ++i) {
    for (GridIndex j = 0; j <= i; ++j) {
      const Float alpha = places_[i] - places_[j], normal = over_pi * kernels_.smooth_normal_slope(alpha);
      smooth_[0](i, j) = normal;
      smooth_[1](i, j) = smooth_[1](j, i) = over_pi * kernels_.coupling_slope(alpha);
      smooth_[2](i, j) = normal - over_pi * kernels_.coupling(alpha);
      smooth_[0](j, i) = -smooth_[0](i, j);
      smooth_[2](j, i) = -smooth_[2](i, j);
    }
  }
  const GridIndex nodes = grid_->nodes();
  for (Panel& panel : panels_) {
    panel.moments = Matrix(panel.chebyshev.count(), nodes + 2);
    for (GridIndex i = 0; i < nodes; ++i) {
      const auto at_node = lagrange(panel.chebyshev, {grid_->from_left()[i], grid_->from_right()[i]});
      for (GridIndex a = 0; a < at_node.count(); ++a) {
        const Float moment = panel.length * grid_->weight()[i] * at_node[a].re;
        panel.moments(a, i) = moment;
        panel.moments(a, nodes) += moment * grid_->from_right()[i];
        panel.moments(a, nodes + 1) += moment * grid_->from_left()[i];
      }
    }
  }
}

bool SlipContact::enters_stick(GridIndex panel) const {
  return panel > 0 && panels_[panel].sign == 0 && panels_[panel - 1].sign != 0;
}

GridIndex SlipContact::equations() const {
  GridIndex count = problem_.creep ? 1 : 2;
  for (GridIndex panel = 0; panel < panels_.count(); ++panel)
    count += (panels_[panel].sign == 0 ? 2 : 1) * (grid_->nodes() + 1) + (enters_stick(panel) ? 1 : 0);
  return count;
}

void SlipContact::set(const Vector& unknowns) {
  leading_ = unknowns(leading_column_) * problem_.unit;
  creep_ = problem_.creep ? *problem_.creep : Float(unknowns(creep_column_) * problem_.unit);
  const auto count = places_.count();
  moments_ = {Vector(count), Vector(count)};
  for (Panel& panel : panels_) {
    for (std::size_t of : {pressure_part, shear_part}) {
      for (GridIndex i = 0; i < panel.values[of].count(); ++i) {
        const Source& source = panel.sources[of][i];
        panel.values[of][i] =
            source.column < 0 ? Float(0) : Float(source.factor * unknowns(source.column) * problem_.unit);
      }
      Float product = 0;
      for (GridIndex a = 0; a < panel.moments.rows(); ++a)
        for (GridIndex i = 0; i < panel.moments.cols(); ++i)
          add_product(moments_[of](panel.first_place + a), product, panel.moments(a, i), panel.values[of][i]);
    }
  }
  normal_ = smooth_[0] * moments_[pressure_part] - smooth_[1] * moments_[shear_part];
  tangential_ = smooth_[1] * moments_[pressure_part] + smooth_[2] * moments_[shear_part];
}

Vector SlipContact::unknowns_of(const SlipField& other) const {
  Vector unknowns(columns_);
  const GridIndex nodes = grid_->nodes();
  const auto put = [&](const Source& source, const Float& value) {
    if (source.column >= 0) unknowns(source.column) = value / (source.factor * problem_.unit);
  };
  for (const Panel& panel : panels_) {
    for (std::size_t of : {shear_part, pressure_part}) {
      const Float right = panel.left + panel.length, at_left = other.traction(of, panel.left),
                  at_right = other.traction(of, right);
      put(panel.sources[of][nodes], at_left);
      put(panel.sources[of][nodes + 1], at_right);
      for (GridIndex i = 0; i < nodes; ++i) {
        const Float &from_left = grid_->from_left()[i], &from_right = grid_->from_right()[i];
        const Float e = from_left < from_right ? panel.left + panel.length * from_left
                                               : right - panel.length * from_right;
        put(panel.sources[of][i], other.traction(of, e) - from_right * at_left - from_left * at_right);
      }
    }
  }
  unknowns(leading_column_) = other.contact().leading() / problem_.unit;
  if (creep_column_ >= 0) unknowns(creep_column_) = other.contact().creep() / problem_.unit;
  return unknowns;
}

Float SlipContact::shift(int sign) const {
  return atan(Float(problem_.beta * problem_.friction * sign)) / pi();
}

ComplexFloat SlipContact::collocation(const Panel& panel, GridIndex row) const {
  const Float middle = row - Float(1) / 2;
  return panel.sign == 0 ? ComplexFloat(middle, -atanh(problem_.beta) / pi())
                         : ComplexFloat(middle + shift(panel.sign));
}

Float SlipContact::gap(GridIndex from, GridIndex to) const {
  Float sum = 0;
  for (GridIndex i = std::min(from, to) + 1; i < std::max(from, to); ++i) sum += panels_[i].length;
  return sum;
}

/// Of a panel from beyond one of its ends; `way` is the distance from that over its length.
void SlipContact::add_outer(GridIndex source, const ComplexFloat& way, bool is_ahead,
                            Row<ComplexFloat>& sums) const {
  const GridIndex nodes = grid_->nodes();
  const Float over_pi = 1 / pi();
  const Row<Float>&near = is_ahead ? grid_->from_left() : grid_->from_right(),
        &far = is_ahead ? grid_->from_right() : grid_->from_left();
  ComplexFloat* const values = &sums[source * (nodes + 2)];
  ComplexFloat &at_near = values[nodes + (is_ahead ? 0 : 1)], &at_far = values[nodes + (is_ahead ? 1 : 0)];
  const Float sign = (is_ahead ? 1 : -1) * over_pi;
  at_near = at_far = ComplexFloat();
  const bool is_near = abs(way) < 1;
  ComplexFloat scratch, distance = way;
  for (GridIndex i = 0; i < nodes; ++i) {
    mpfr_add(raw(distance.re), raw(way.re), raw(near[i]), MPFR_RNDN);
    set_quotient(values[i], is_ahead ? weights_[i] : minus_weights_[i], distance, scratch);
    if (is_near) continue;
    at_near = at_near + values[i] * far[i];
    at_far = at_far + values[i] * near[i];
  }
  if (!is_near) return;
  const ComplexFloat beyond = way + ComplexFloat(1), angle = log(beyond / way);
  at_near = (beyond * angle - ComplexFloat(1)) * sign;
  at_far = (ComplexFloat(1) - way * angle) * sign;
}

void SlipContact::cauchy(GridIndex panel, const PanelPoint& at, Row<ComplexFloat>& sums) const {
  const GridIndex nodes = grid_->nodes();
  sums.grow(panels_.count() * (nodes + 2));
  const Float over_pi = 1 / pi(), &length = panels_[panel].length;
  for (GridIndex source = 0; source < panels_.count(); ++source) {
    if (source == panel) continue;
    const bool is_ahead = source > panel;
    const ComplexFloat way =
        (is_ahead ? at.from_right : at.from_left) * length + ComplexFloat(gap(panel, source));
    add_outer(source, way / panels_[source].length, is_ahead, sums);
  }
  ComplexFloat* const values = &sums[panel * (nodes + 2)];
  const bool is_left = at.from_left.re < at.from_right.re;
  ComplexFloat scratch, way = is_left ? -at.from_left : at.from_right;
  for (GridIndex i = 0; i < nodes; ++i) {
    if (is_left)
      mpfr_sub(raw(way.re), raw(grid_->from_left()[i]), raw(at.from_left.re), MPFR_RNDN);
    else
      mpfr_sub(raw(way.re), raw(at.from_right.re), raw(grid_->from_right()[i]), MPFR_RNDN);
    set_quotient(values[i], weights_[i], way, scratch);
  }
  const ComplexFloat angle = log(at.from_right / at.from_left);
  values[nodes] = (at.from_right * angle - ComplexFloat(1)) * over_pi;
  values[nodes + 1] = (at.from_left * angle + ComplexFloat(1)) * over_pi;
}

PointSums SlipContact::add_up(const Row<ComplexFloat>& cauchy) const {
  PointSums sums;
  Float product = 0;
  GridIndex first = 0;
  for (const Panel& source : panels_) {
    const GridIndex count = source.values[pressure_part].count();
    const auto sum_of = [&](std::size_t of) {
      ComplexFloat sum;
      for (GridIndex i = 0; i < count; ++i) {
        const ComplexFloat& factor = cauchy[first + i];
        add_product(sum.re, product, factor.re, source.values[of][i]);
        if (!factor.is_real()) add_product(sum.im, product, factor.im, source.values[of][i]);
      }
      return sum;
    };
    const ComplexFloat pressed = sum_of(pressure_part);
    sums.normal = sums.normal + pressed;
    sums.tangential = sums.tangential + (source.sign == 0 ? sum_of(shear_part)
                                                          : pressed * Float(source.sign * problem_.friction));
    first += count;
  }
  return sums;
}

PointSums SlipContact::sums(GridIndex number, const PanelPoint& at) const {
  const Panel& panel = panels_[number];
  const GridIndex nodes = grid_->nodes();
  Row<ComplexFloat> coefficients;
  cauchy(number, at, coefficients);
  PointSums sums = add_up(coefficients);
  const auto linear = [&](std::size_t of) {
    return at.from_right * panel.values[of][nodes] + at.from_left * panel.values[of][nodes + 1];
  };
  sums.normal = sums.normal + linear(shear_part) * problem_.beta;
  sums.tangential = sums.tangential - linear(pressure_part) * problem_.beta;
  const auto weights = lagrange(panel.chebyshev, at);
  for (GridIndex a = 0; a < weights.count(); ++a) {
    sums.normal = sums.normal + weights[a] * normal_(panel.first_place + a);
    sums.tangential = sums.tangential + weights[a] * tangential_(panel.first_place + a);
  }
  return sums;
}

PointSums SlipContact::sums_outside(const Float& e) const {
  Row<ComplexFloat> coefficients;
  coefficients.grow(panels_.count() * (grid_->nodes() + 2));
  for (GridIndex source = 0; source < panels_.count(); ++source) {
    const Panel& of = panels_[source];
    const Float way = e < 0 ? of.left - e : e - of.left - of.length;
    add_outer(source, way / of.length, e < 0, coefficients);
  }
  PointSums sums = add_up(coefficients);
  for (GridIndex i = 0; i < places_.count(); ++i) {
    const Float alpha = e - places_[i], normal = kernels_.smooth_normal_slope(alpha),
                coupling = kernels_.coupling_slope(alpha);
    const Float &pressed = moments_[pressure_part](i), &sheared = moments_[shear_part](i);
    sums.normal.re += (normal * pressed - coupling * sheared) / pi();
    sums.tangential.re += (coupling * pressed + (normal - kernels_.coupling(alpha)) * sheared) / pi();
  }
  return sums;
}

Vector SlipContact::residual() const {
  Vector rest(equations());
  GridIndex row = 0;
  const Float& unit = problem_.unit;
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    const Panel& panel = panels_[number];
    for (GridIndex i = 0; i <= grid_->nodes(); ++i) {
      const PanelPoint at = grid_->at(collocation(panel, i));
      const PointSums of = sums(number, at);
      const ComplexFloat behind = ComplexFloat(panel.left - leading_) + at.from_left * panel.length;
      const ComplexFloat normal = of.normal + behind * Float(2);
      if (panel.sign != 0) {
        rest(row++) = normal.re / unit;
      } else {
        rest(row++) = (normal.re - of.tangential.im) / unit;
        rest(row++) = (normal.im + of.tangential.re - creep_) / unit;
      }
    }
  }
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    if (!enters_stick(number)) continue;
    const auto& values = panels_[number].values;
    const int sign = panels_[number - 1].sign;
    rest(row++) = (values[shear_part][0] - sign * problem_.friction * values[pressure_part][0]) /
                  (unit * pow(grid_->from_left()[0], Float(Float(1) / 2 + shift(sign))));
  }
  rest(row++) = problem_.length ? Float((length() - *problem_.length) / unit)
                                : Float((integral(pressure_part) - problem_.load) / (unit * unit));
  if (!problem_.creep) rest(row++) = (integral(shear_part) - problem_.shear) / (unit * unit);
  return rest;
}

/// What a row has of the traction of Cauchy's integrals, of the panel's own ends and of the smooth kernels. The values at a joint
/// are those of the panel before it, as one unknown is in both: their logarithms cancel there.
Row<ComplexFloat> SlipContact::terms(GridIndex number, const PanelPoint& at) const {
  Row<ComplexFloat> terms;
  cauchy(number, at, terms);
  const GridIndex nodes = grid_->nodes(), block = nodes + 2;
  for (GridIndex left = block + nodes; left < terms.count(); left += block) {
    terms[left - nodes - 1] = terms[left - nodes - 1] + terms[left];
    terms[left] = ComplexFloat();
  }
  terms.push_back(at.from_right);
  terms.push_back(at.from_left);
  for (ComplexFloat& weight : lagrange(panels_[number].chebyshev, at)) terms.push_back(std::move(weight));
  return terms;
}

/// Rows by values of p, then of q.
Eigen::MatrixXcd SlipContact::panel_slopes(GridIndex number) const {
  const Panel& panel = panels_[number];
  const GridIndex nodes = grid_->nodes(), block = nodes + 2, all = panels_.count() * block;
  const auto points = panel.chebyshev.count();
  const Complex turn(0, panel.sign == 0 ? 1 : 0);
  const auto beta = static_cast<double>(problem_.beta);
  Eigen::MatrixXcd rows(nodes + 1, all + 2 + points);
  Row<ComplexFloat> last;
  const auto store = [&](GridIndex row, const Row<ComplexFloat>& of, const Row<ComplexFloat>& less) {
    const Float scale = row_scale(panel, row);
    for (GridIndex i = 0; i < of.count(); ++i)
      rows(row, i) = in_double((less.empty() ? of[i] : of[i] - less[i]) * scale);
  };
  for (GridIndex row = 0; row <= nodes; ++row) {
    Row<ComplexFloat> now = terms(number, grid_->at(collocation(panel, row)));
    if (row > 0 && 2 * row <= nodes) store(row - 1, last, now);
    if (2 * row == nodes) store(row, now, {});
    if (2 * row > nodes) store(row, now, last);
    last = std::move(now);
  }
  Eigen::MatrixXcd slopes(nodes + 1, 2 * all);
  slopes << rows.leftCols(all), turn * rows.leftCols(all);
  const auto ends = rows.middleCols(all, 2);
  const Eigen::MatrixXcd interpolation = rows.rightCols(points);
  const GridIndex own = number * block + nodes;
  slopes.middleCols(own, 2) -= turn * beta * ends;
  slopes.middleCols(all + own, 2) += beta * ends;
  for (GridIndex source = 0; source < panels_.count(); ++source) {
    const Eigen::MatrixXd moments = panels_[source].moments.cast<double>();
    const auto between = [&](std::size_t kernel) -> Eigen::MatrixXd {
      return smooth_[kernel]
                 .block(panel.first_place, panels_[source].first_place, points, moments.rows())
                 .cast<double>() *
             moments;
    };
    const Eigen::MatrixXd normal = between(0), coupling = between(1), tangential = between(2);
    const GridIndex first = source * block;
    slopes.middleCols(first, block) += interpolation * (normal + turn * coupling);
    slopes.middleCols(all + first, block) += interpolation * (turn * tangential - coupling);
  }
  return slopes;
}

/// Of a row of an equation, over the root of the distance from the nearer end of the panel.
Float SlipContact::row_scale(const Panel& panel, GridIndex row) const {
  const PanelPoint at = grid_->at(ComplexFloat(collocation(panel, row).re));
  return 1 / sqrt(at.from_left.re * at.from_right.re);
}

/// Across the joint with the panel before, where the smooth kernels and the linear parts go on.
Eigen::RowVectorXcd SlipContact::joint_slopes(GridIndex number) const {
  const Panel &before = panels_[number - 1], &panel = panels_[number];
  const GridIndex all = panels_.count() * (grid_->nodes() + 2);
  const auto left = terms(number - 1, grid_->at(collocation(before, grid_->nodes())));
  const auto right = terms(number, grid_->at(collocation(panel, 0)));
  const Float scale = row_scale(panel, 0);
  const Complex turn(0, 1);
  Eigen::RowVectorXcd slopes(2 * all);
  for (GridIndex i = 0; i < all; ++i) {
    const ComplexFloat pressed = right[i] - left[i], sheared = (panel.sign == 0 ? right[i] : ComplexFloat()) -
                                                               (before.sign == 0 ? left[i] : ComplexFloat());
    slopes(i) = in_double(pressed * scale);
    slopes(all + i) = turn * in_double(sheared * scale);
  }
  return slopes;
}

bool SlipContact::is_tied(GridIndex number, GridIndex part) const {
  return number > 0 && (part == 0 || panels_[number - 1].zone == panels_[number].zone);
}

Vector SlipContact::balanced(const Vector& rest) const {
  Vector result = rest;
  GridIndex first = 0, last = 0;
  const GridIndex nodes = grid_->nodes();
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    const Panel& panel = panels_[number];
    const GridIndex parts = panel.sign == 0 ? 2 : 1;
    for (GridIndex row = 0; row <= nodes; ++row) {
      for (GridIndex part = 0; part < parts; ++part) {
        const GridIndex at = first + parts * row + part;
        Float& value = result(at);
        if (2 * row < nodes) value -= rest(at + parts);
        if (2 * row > nodes) value -= rest(at - parts);
        const bool is_joint = 2 * row == nodes && is_tied(number, part);
        if (is_joint) value = rest(first + part) - rest(last + part);
        value *= row_scale(panel, is_joint ? 0 : row);
      }
    }
    first += parts * (nodes + 1);
    last = first - parts;
  }
  return result;
}

DenseMatrix<double> SlipContact::slopes() const {
  const GridIndex nodes = grid_->nodes(), block = nodes + 2, all = panels_.count() * block;
  DenseMatrix<double> matrix(equations(), columns_);
  GridIndex row = 0;
  const auto add = [&](GridIndex at, const Source& source, double slope) {
    if (source.column >= 0) matrix(at, source.column) += static_cast<double>(source.factor) * slope;
  };
  const auto for_values = [&](const auto& use) {
    for (GridIndex number = 0; number < panels_.count(); ++number)
      for (std::size_t of : {pressure_part, shear_part})
        for (GridIndex i = 0; i < block; ++i)
          use(panels_[number], of, i, (of == pressure_part ? 0 : all) + number * block + i);
  };
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    const Eigen::MatrixXcd inside = panel_slopes(number);
    for (GridIndex i = 0; i <= nodes; ++i) {
      for (GridIndex part = 0; part < (panels_[number].sign == 0 ? 2 : 1); ++part, ++row) {
        const bool is_middle = 2 * i == nodes, is_joint = is_middle && is_tied(number, part);
        const Eigen::RowVectorXcd of = is_joint ? joint_slopes(number) : Eigen::RowVectorXcd(inside.row(i));
        for_values([&](const Panel& panel, std::size_t kind, GridIndex value, GridIndex column) {
          add(row, panel.sources[kind][value], part == 0 ? of(column).real() : of(column).imag());
        });
        if (!is_middle || is_joint) continue;
        const auto scale = static_cast<double>(row_scale(panels_[number], i));
        if (part == 0) matrix(row, leading_column_) = -2 * scale;
        if (part == 1 && creep_column_ >= 0) matrix(row, creep_column_) = -scale;
      }
    }
  }
  for (GridIndex number = 0; number < panels_.count(); ++number) {
    if (!enters_stick(number)) continue;
    const int sign = panels_[number - 1].sign;
    const auto scale = static_cast<double>(pow(grid_->from_left()[0], Float(-Float(1) / 2 - shift(sign))));
    add(row, panels_[number].sources[shear_part][0], scale);
    add(row, panels_[number].sources[pressure_part][0],
        -sign * scale * static_cast<double>(problem_.friction));
    ++row;
  }
  const auto add_integral = [&](std::size_t of) {
    for_values([&](const Panel& panel, std::size_t part, GridIndex value, GridIndex) {
      const Float weight = value < nodes ? grid_->weight()[value] : Float(0.5);
      if (part == of)
        add(row, panel.sources[part][value],
            static_cast<double>(Float(panel.length / problem_.unit * weight)));
    });
    ++row;
  };
  if (problem_.length)
    ++row;
  else
    add_integral(pressure_part);
  if (!problem_.creep) add_integral(shear_part);
  for (GridIndex column = 0; column < columns_; ++column)
    matrix.col(column) *= static_cast<double>(sizes_[column]);
  return matrix;
}

Float SlipContact::integral(std::size_t of) const {
  Float sum = 0;
  const GridIndex nodes = grid_->nodes();
  for (const Panel& panel : panels_) {
    Float part = (panel.values[of][nodes] + panel.values[of][nodes + 1]) / 2;
    for (GridIndex i = 0; i < nodes; ++i) part += grid_->weight()[i] * panel.values[of][i];
    sum += panel.length * part;
  }
  return sum;
}

Float SlipContact::length() const { return panels_.back().left + panels_.back().length; }

}  // namespace nipref::ref
