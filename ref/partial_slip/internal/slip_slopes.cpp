#include <complex>
#include <utility>

#include <nipref/ref/partial_slip/internal/slip_solution.hpp>

namespace nipref::ref {
namespace {

using Complex = std::complex<double>;
using ComplexRow = Eigen::RowVectorXcd;
using Equation = SlipContact::Equation;
/// Several numbers at each point of each panel.
using PointRows = Row<Row<Row<ComplexFloat>>>;

/// What turns the shear's equation.
constexpr Complex turn{0, 1};

Complex in_double(const ComplexFloat& x) { return {static_cast<double>(x.re), static_cast<double>(x.im)}; }

Eigen::ArrayXd in_double(const Row<Float>& values) {
  Eigen::ArrayXd result(values.count());
  for (GridIndex i = 0; i < values.count(); ++i) result(i) = static_cast<double>(values[i]);
  return result;
}

class Slopes {
 public:
  explicit Slopes(const SlipContact& contact)
      : contact_(contact),
        panels_(contact.panels()),
        nodes_(contact.grid().nodes()),
        constant_(contact.sizes().count()),
        from_left_(in_double(contact.grid().from_left())),
        from_right_(in_double(contact.grid().from_right())),
        weights_(in_double(contact.grid().weight()) / static_cast<double>(pi())),
        smooth_(contact.smooth().slopes()),
        matrix_(Eigen::MatrixXd::Zero(contact.equations().count() + contact.conditions().count(),
                                      constant_ + 1)) {
    for (GridIndex panel = 0; panel < panels_.count(); ++panel) {
      hats_.emplace_back();
      local_.emplace_back();
      for (GridIndex i = 0; i <= nodes_; ++i) {
        const ContactPoint point = contact.point({panel, i});
        const ComplexFloat e = panels_.place(point);
        hats_[panel].push_back(cauchy_hats(panels_, point));
        hats_[panel][i].push_back(e * Float(2));
        local_[panel].push_back(contact.smooth().lagrange(e));
        for (const ComplexFloat& end : {point.at.from_right, point.at.from_left})
          local_[panel][i].push_back(end);
      }
    }
  }

  Eigen::MatrixXd matrix() {
    OfBoth<ComplexRow> by_values;
    for (GridIndex row = 0; row < contact_.equations().count(); ++row) {
      const Equation& equation = contact_.equations()[row];
      // A place's second equation follows its first.
      if (row == 0 || !equation.is_at_place_of(contact_.equations()[row - 1]))
        by_values = slopes_of(equation);
      const bool is_first = equation.part == 0;
      const ComplexRow place = difference(hats_, equation, sides(equation, pressure_part)).tail(1);
      matrix_(row, constant_) = is_first ? place(0).real() : place(0).imag();
      for (std::size_t of : {pressure_part, shear_part})
        add(row, of,
            is_first ? Eigen::VectorXd(by_values[of].real()) : Eigen::VectorXd(by_values[of].imag()));
      const GridIndex common = is_first ? contact_.leading_column() : contact_.creep_column();
      if (!equation.less && common >= 0)
        matrix_(row, common) = (is_first ? -2 : -1) * static_cast<double>(equation.scale);
    }
    GridIndex row = contact_.equations().count();
    for (const auto& [factors, wanted] : contact_.conditions()) {
      for (std::size_t of : {pressure_part, shear_part}) add(row, of, factors[of].cast<double>());
      matrix_(row++, constant_) = -static_cast<double>(wanted);
    }
    for (GridIndex i = 0; i < constant_; ++i) matrix_.col(i) *= static_cast<double>(contact_.sizes()[i]);
    return std::move(matrix_);
  }

 private:
  struct Sides {
    bool at, less;
  };

  void add(GridIndex row, std::size_t of, const Eigen::VectorXd& slopes) {
    for (GridIndex i = 0; i < panels_.values(); ++i) {
      const auto& [column, factor] = contact_.sources()[of][i];
      if (column >= 0) matrix_(row, column) += factor * slopes(i);
    }
  }

  /// At which of an equation's points Cauchy's integral of p or q has a part in it.
  [[nodiscard]] Sides sides(const Equation& equation, std::size_t of) const {
    const auto has = [&](GridIndex panel) { return of == pressure_part || panels_[panel].sign == 0; };
    return {has(equation.at.panel), equation.less && has(equation.less->panel)};
  }

  /// Of the complex left side by all values of p and q.
  [[nodiscard]] OfBoth<ComplexRow> slopes_of(const Equation& equation) const {
    const GridIndex panel = equation.at.panel;
    OfBoth<ComplexRow> slopes;
    for (std::size_t of : {pressure_part, shear_part}) {
      slopes[of] = ComplexRow::Zero(panels_.values());
      const Sides has = sides(equation, of);
      if (!has.at && !has.less) continue;
      for (GridIndex from = 0; from < panels_.count(); ++from)
        slopes[of].segment(panels_[from].first, nodes_) = of_nodes(equation, from, has);
      const ComplexRow hats = difference(hats_, equation, has);
      for (GridIndex joint = 1; joint < panels_.count(); ++joint)
        slopes[of](panels_[joint].first + nodes_) = hats(joint);
    }
    slopes[shear_part] *= turn;
    // Across a joint the rest goes on.
    if (equation.less && equation.less->panel != panel) return slopes;
    const Complex turned = panels_[panel].sign == 0 ? turn : 0;
    const ComplexRow local = difference(local_, equation, {true, equation.less.has_value()}),
                     lagrange = local.head(local.size() - 2),
                     ends = local.tail(2) * static_cast<double>(contact_.problem().beta);
    const auto& [normal, coupling, tangential] = smooth_;
    const ComplexRow coupled = lagrange * coupling;
    slopes[pressure_part] += lagrange * normal + turned * coupled;
    slopes[shear_part] += turned * (lagrange * tangential) - coupled;
    slopes[pressure_part].segment(panels_[panel].first + nodes_, 2) -= turned * ends;
    slopes[shear_part].segment(panels_[panel].first + nodes_, 2) += ends;
    return slopes;
  }

  /// Of the rule's sum over a panel. 1/(d + x) less the same at another d is taken in closed form.
  [[nodiscard]] ComplexRow of_nodes(const Equation& equation, GridIndex panel, const Sides& has) const {
    const ContactPoint at = contact_.point(equation.at);
    const CauchyTerms here(panels_, contact_.grid(), at, panel, at),
        there(panels_, contact_.grid(), contact_.point(equation.less.value_or(equation.at)), panel, at);
    const auto over = [&](const CauchyTerms& terms) -> Eigen::ArrayXcd {
      return 1. / ((terms.sign > 0 ? from_left_ : from_right_) + in_double(terms.distance));
    };
    Eigen::ArrayXcd values = has.at ? over(here) : -over(there);
    if (has.at && has.less) values *= in_double(there.distance - here.distance) * over(there);
    return (static_cast<double>(here.sign * equation.scale) * weights_ * values).matrix().transpose();
  }

  static ComplexRow difference(const PointRows& rows, const Equation& equation, const Sides& has) {
    const auto& [at, less, part, scale] = equation;
    const Row<ComplexFloat>& first = rows[at.panel][at.point];
    ComplexRow result(first.count());
    for (GridIndex i = 0; i < first.count(); ++i) {
      ComplexFloat value = has.at ? first[i] : ComplexFloat();
      if (has.less) value = value - rows[less->panel][less->point][i];
      result(i) = in_double(value * scale);
    }
    return result;
  }

  const SlipContact& contact_;
  const ZonePanels& panels_;
  GridIndex nodes_, constant_;
  Eigen::ArrayXd from_left_, from_right_, weights_;
  std::array<Eigen::MatrixXd, 3> smooth_;
  PointRows hats_;   ///< and 2 e
  PointRows local_;  ///< Lagrange's polynomials, and the linear ones of both ends
  Eigen::MatrixXd matrix_;
};

}  // namespace

Eigen::MatrixXd slopes(const SlipContact& contact) { return Slopes(contact).matrix(); }

}  // namespace nipref::ref
