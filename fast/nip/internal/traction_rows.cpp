#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <nipref/fast/nip/internal/tractions.hpp>
#include <nipref/fast/number/internal/cache.hpp>
#include <nipref/fast/number/internal/chebyshev.hpp>
#include <nipref/fast/number/internal/double_exponential.hpp>
#include <nipref/fast/number/internal/gauss_legendre.hpp>
#include <nipref/fast/number/internal/linear_system.hpp>

namespace nipref::fast {
namespace {

using Complex = std::complex<double>;

constexpr double decayed = 40;  ///< an exponential that has fallen by so many nats is negligible
/// The most points of a product rule; if it needs more, other rules need fewer. The second number holds on a panel on
/// which the kernel is analytic or its logarithm is integrated separately, the first on a panel beside the singularity.
constexpr int most_points_beside_singularity = 64, most_points_where_analytic = 256;

/// The distances from the start of exponentials with these rates at which an integral over them is cut into pieces. Up
/// to a few lengths 1/|rate| the integrand is analytic. Where an exponential has decayed, the integrand falls like a
/// power. Over a factor of 150 in the distance the rule resolves a power, but not an exponential. An exponential that
/// oscillates counts until it has decayed relative to its size at the distance `to_contact`.
std::vector<double> cuts_of_exponentials(const std::vector<Complex>& rates, double to_contact,
                                         double farthest) {
  constexpr double few_lengths = 6, radians = 20, resolved_ratio = 150;
  std::vector<double> result;
  for (const Complex& rate : rates) {
    const double size = std::abs(rate);
    double cut = few_lengths / size;
    if (rate.imag() != 0) {
      cut = std::max(cut, to_contact);
      for (; rate.real() * (cut - to_contact) < decayed && cut < farthest;
           cut += std::min(cut, radians / size))
        result.push_back(cut);
    } else if (cut < 0.5 * farthest) {
      result.push_back(cut);
      cut = decayed / size;
    }
    for (; cut < 0.5 * farthest; cut *= resolved_ratio) result.push_back(cut);
  }
  return result;
}

/// |z| of the slowest residue term e^(-z alpha) of an elastic kernel.
constexpr double slowest_rate = 2.4;

double largest(const std::vector<Complex>& rates) {
  double size = 0;
  for (const Complex& rate : rates) size = std::max(size, std::abs(rate));
  return size;
}

/// A piece is integrated by Gauss's rule if it is at least this many times its width away from poles off the real axis.
constexpr double apart = 1.3;

/// The distances from poles at which an integral is cut into pieces. The double-exponential rule resolves the poles on
/// each piece. If the poles are off the real axis, the first few pieces are so narrow that Gauss's rule suffices.
std::vector<double> cuts_of_poles(double distance, double off_axis, double farthest) {
  constexpr int few = 6;
  constexpr double resolved_ratio = 60;
  std::vector<double> result;
  // A piece of this width is far enough from the poles for Gauss's rule, in spite of rounding.
  const auto width_from = [&](double cut) { return std::hypot(cut, off_axis) / (1.01 * apart); };
  double cut = off_axis > 0 ? width_from(0) : 2 * distance;
  for (int i = 0; 0 < cut && cut < farthest; ++i) {
    result.push_back(cut);
    cut = off_axis > 0 && i < few ? cut + width_from(cut) : cut * resolved_ratio;
  }
  return result;
}

/// Whether one of the exponentials oscillates, has not decayed at `distance` relative to its size at `to_contact`, and
/// varies too much over the width to be approximated by a polynomial.
bool oscillates(const std::vector<Complex>& rates, double to_contact, double distance, double width) {
  return std::ranges::any_of(rates, [&](const Complex& rate) {
    return rate.imag() != 0 && rate.real() * (distance - to_contact) < decayed && std::abs(rate) * width > 5;
  });
}

/// ln(3 + sqrt 8): the nats a degree by which a polynomial grows from [-1, 1] to the ellipse with foci +-1 through +-3.
const double nats_of_ellipse = 2 * std::asinh(1.0);

/// The degree of a polynomial that grows on that ellipse as much as an exponential over a piece. `phase` is |rate|
/// times the width of the piece; the ellipse is up to sqrt 2 widths away from the piece. Pieces on which an exponential
/// counts are at most 20 radians wide. There its Chebyshev coefficients are Bessel functions of 10, which are below
/// 1e-16 from degree 36 on. The nodes for 20 degrees suffice for these, together with the nodes for the tolerance.
double degree_of_exponential(double phase) {
  return std::min(phase * std::numbers::sqrt2 / nats_of_ellipse, 20.0);
}

/// On a piece, a part p of a panel, a polynomial of degree n over the panel grows like a polynomial of this degree. On
/// the piece's ellipse of L nats a degree it grows by n g, g the nats of the panel's ellipses. g follows from the sum
/// of the distances from the panel's ends, a convex function of the position of the piece, which is largest if the
/// piece is at an end. There cos(theta/2) = sqrt p cos(theta'/2), with theta of the panel, theta' of the piece and
/// Im theta' = L, so that g is at most 2 arsinh(sqrt p sinh(L/2)). g/L grows with L; for that ellipse sinh(L/2) = 1.
double degree_on_part(int degree, double part) {
  return degree * std::asinh(std::sqrt(std::min(part, 1.0))) / std::asinh(1.0);
}

/// Gauss's rule for a function that grows on that ellipse like a polynomial of the degree. The number of nodes is a
/// multiple of four, so that few rules are cached.
std::shared_ptr<const GaussRule> cached_gauss(double degree, double tolerance) {
  static Cache<int, GaussRule> rules(gauss_legendre);
  const double nodes = degree / 2 + 2 - std::log(tolerance) / (2 * nats_of_ellipse);
  return rules.at(4 * static_cast<int>(std::ceil(nodes / 4)));
}

/// The double-exponential rule for a polynomial of the degree, up to the next multiple of eight so that few are cached.
std::shared_ptr<const std::vector<UnitNode>> cached_rule(double tolerance, double degree) {
  using Key = std::pair<double, int>;
  static Cache<Key, std::vector<UnitNode>> rules(
      [](const Key& key) { return double_exponential_rule(key.first, key.second); });
  return rules.at({tolerance, 8 * static_cast<int>(std::ceil(degree / 8))});
}

/// A number of points of a product rule, `least` rounded up to an even step so that few rules are cached.
int rounded_up_points(double least) {
  const double points = std::min(least, 1e6), step = points < 64 ? 4 : 16;
  return static_cast<int>(step * std::ceil(points / step));
}
/// The number of points for an accuracy of `nats`, if each point gives `nats_a_point`.
int points_of_rule(double nats_a_point, double nats) { return rounded_up_points(1 + nats / nats_a_point); }

Eigen::ArrayXd array(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The sums over the nodes, rows, of a panel about the middle, where the weights of Re g are even, those of Im g odd.
Eigen::MatrixXd sums_of_halves(const auto& at_nodes, const auto& weights, double parity) {
  const Eigen::Index half = weights.rows() / 2;
  const Eigen::MatrixXd both =
      (at_nodes.topRows(half) + parity * at_nodes.bottomRows(half).colwise().reverse()).transpose();
  return product(both, weights.topRows(half));
}

/// One of the four sums in g = sum (a_k + i b_k) phi_k, whose real part is sum a_k Re phi_k - sum b_k Im phi_k and whose
/// imaginary part is sum a_k Im phi_k + sum b_k Re phi_k.
struct Summand {
  int component;  ///< 0 of a_k, 1 of b_k
  Eigen::MatrixXd PanelBasis::Rows::*of_basis;
  bool is_in_real;  ///< in Re g, on which on_p acts
  double sign;
};
constexpr Summand summands[] = {{0, &PanelBasis::Rows::real, true, 1},
                                {0, &PanelBasis::Rows::imaginary, false, 1},
                                {1, &PanelBasis::Rows::real, false, 1},
                                {1, &PanelBasis::Rows::imaginary, true, -1}};

}  // namespace

/// Computes the rows of one kernel: sums over the nodes of quadrature rules on each panel.
class Tractions::Sums {
 public:
  Sums(const Tractions& tractions, const Kernel& kernel, double tolerance)
      : of_(tractions), kernel_(kernel), tolerance_(tolerance), reach_(-std::log(tolerance) / 2.1) {}

  /// Adds all panels to the rows of a place but `done`, if there is such a panel; its mirror image is added, too.
  void add_place(const Place& place, std::size_t done, Rows rows) const {
    Nodes nodes;
    bool layers_left = !of_.layers_.empty();
    for (std::size_t p = 0; p < of_.panels_.size(); ++p) {
      const Panel& panel = of_.panels_[p];
      nodes.clear();
      bool with_layers = false;
      for (const bool mirrored : {false, true}) {
        if (mirrored) nodes.on_this_half = nodes.e.size();
        if (mirrored ? panel.about_middle : done == p) continue;
        if (!acts_on(panel, singular_at(place, mirrored)) || add_by_product_rule(place, p, mirrored, rows) ||
            add_beside_logarithm(place, p, mirrored, rows))
          continue;
        const bool has_layers = p == 0 && mirrored == place.trailing && !of_.layers_.empty();
        with_layers |= has_layers;
        append_panel(panel, place, mirrored, has_layers ? of_.layer_rates() : std::vector<Complex>(), nodes);
      }
      if (!nodes.e.empty()) add_rows(p, nodes, place.trailing, with_layers, rows);
      if (with_layers) layers_left = false;
    }
    if (layers_left) rows.rightCols(of_.layer_columns()) += layer_rows(place);
  }

  /// The columns of the layers, which are on the leading half.
  [[nodiscard]] Eigen::MatrixXd layer_rows(const Place& place) const {
    const Panel& panel = of_.panels_.front();
    if (!acts_on(panel, singular_at(place, place.trailing)))
      return Eigen::MatrixXd::Zero(kernel_.functionals, of_.layer_columns());
    Nodes nodes;
    append_panel(panel, place, place.trailing, of_.layer_rates(), nodes);
    const Eigen::ArrayXd alpha = (place.trailing ? -1 : 1) * array(nodes.alpha);
    Eigen::MatrixXd on_p, on_q;
    kernel_.at({alpha.data(), nodes.alpha.size()}, on_p, on_q);
    return sums_of_layers(on_p + on_q, array(nodes.weight).matrix().transpose(), array(nodes.e));
  }

  /// Adds a panel to the rows of its own matching points, which begin at `first`: the kernel's logarithm and jump by
  /// the singular integrals of the basis, the rest by a product rule. Returns false if the panel is too wide for that.
  bool add_own_panel(std::size_t p, const SplitKernel& split, Eigen::Index first, MatchingRows& result) const;

 private:
  /// Quadrature nodes on one panel and its mirror image, those on the half of the place first.
  struct Nodes {
    std::vector<double> e, other;  ///< distances from the end of the node's half and from the other end
    std::vector<double> weight, alpha;
    std::size_t on_this_half = 0;

    void clear() {
      for (std::vector<double>* values : {&e, &other, &weight, &alpha}) values->clear();
      on_this_half = 0;
    }
    void grow(std::size_t count) {
      for (std::vector<double>* values : {&e, &other, &weight, &alpha})
        values->resize(values->size() + count);
    }
  };
  /// Properties of the integrand on a panel that determine the rules.
  struct Integrand {
    int degree;          ///< of the polynomials
    double width;        ///< of the panel on which they are polynomials
    double rate;         ///< the largest |rate| of the exponentials that multiply them
    double off_axis;     ///< distance of a regular kernel's poles from the real axis; 0 of other kernels
    bool is_polynomial;  ///< whether nothing else multiplies them, as the factor of the panel at the end does
  };

  /// e where the kernel is singular, from the end of the half of the place, or, if mirrored, from the other end.
  [[nodiscard]] double singular_at(const Place& place, bool mirrored) const {
    return mirrored ? 2 * of_.half_length_ - place.e : place.e;
  }
  /// The distance of a place from the contact.
  static double outside(const Place& place) { return std::max(-place.e, 0.0); }
  /// Whether the kernel that is singular at this place is more than negligible on a panel.
  [[nodiscard]] bool acts_on(const Panel& panel, double singular) const {
    return kernel_.beyond_reach != Kernel::FarAway::negligible ||
           !is_beyond_reach(panel.left, panel.right, singular);
  }

  /// Whether a panel or a piece is so far away that the kernel's parts that decay are negligible.
  [[nodiscard]] bool is_beyond_reach(double from, double to, double singular) const {
    return to <= singular - reach_ || from >= singular + reach_;
  }
  [[nodiscard]] bool is_linear(double from, double to, double singular) const {
    return kernel_.beyond_reach == Kernel::FarAway::linear && is_beyond_reach(from, to, singular);
  }

  /// Appends the nodes of a piece of a panel. The kernel is singular at `singular` or `off_axis` beside it, not inside
  /// the piece. The rule is Gauss's where the integrand is a polynomial, and where the singularity and the ends of the
  /// contact are farther than the piece is wide.
  void append_piece(double from, double to, double singular, const Integrand& integrand, bool mirrored,
                    Nodes& nodes) const {
    const double width = to - from, beyond = 2 * of_.half_length_ - to, sign = mirrored ? -1 : 1;
    // All nodes that count are farther than this. Any nearer, the kernels' logarithms would overflow.
    constexpr double nearest = 1e-299;
    std::size_t i = nodes.e.size();
    const auto append = [&](double from_left, double from_right, double weight) {
      const double distance =
          singular <= from ? (from - singular) + width * from_left : -((singular - to) + width * from_right);
      nodes.e[i] = from + width * from_left;
      nodes.other[i] = beyond + width * from_right;
      nodes.weight[i] = width * weight;
      nodes.alpha[i] = std::copysign(std::max(std::fabs(distance), nearest), sign * distance);
      ++i;
    };
    const double distance_along = std::max(from - singular, singular - to);
    const bool is_apart = distance_along >= width ||
                          std::hypot(std::max(distance_along, 0.0), integrand.off_axis) >= apart * width;
    const double degree = degree_on_part(integrand.degree, width / integrand.width) +
                          degree_of_exponential(integrand.rate * width);
    const auto append_gauss = [&](const std::shared_ptr<const GaussRule>& rule) {
      nodes.grow(rule->at.size());
      for (std::size_t k = 0; k < rule->at.size(); ++k) append(rule->at[k], 1 - rule->at[k], rule->weight[k]);
    };
    constexpr double of_poles = 2;  // the poles may be a little inside the ellipse
    if (integrand.is_polynomial && is_linear(from, to, singular))
      return append_gauss(cached_gauss(integrand.degree + 1, 1));
    if (is_apart && std::min(from, beyond) >= width && width <= 8)
      return append_gauss(cached_gauss(degree + of_poles, tolerance_));
    const auto rule = cached_rule(tolerance_, degree);
    nodes.grow(rule->size());
    for (const UnitNode& node : *rule) append(node.from_left, node.from_right, node.weight);
  }

  /// Appends the nodes of a panel, in pieces that end where the kernel is singular and where it has decayed. `rates`
  /// are those of exponentials in the tractions that start at the end of the contact.
  void append_panel(const Panel& panel, const Place& place, bool mirrored, const std::vector<Complex>& rates,
                    Nodes& nodes) const {
    const double outside = Sums::outside(place), singular = singular_at(place, mirrored);
    const double gap = std::max(panel.left - singular, singular - panel.right);
    std::vector<double> ends = cuts_of_exponentials(rates, 0, panel.right);
    ends.insert(ends.end(), {panel.left, panel.right});
    // On a wide panel Gauss's rule suffices between 5, 10 and the reach, which is at most 18 half-thicknesses.
    for (const double distance : {0.0, 5.0, std::min(10.0, reach_), reach_}) {
      for (const double cut : {singular - distance, singular + distance}) {
        if (panel.left < cut && cut < panel.right && (distance == 0 || panel.width() > 8))
          ends.push_back(cut);
      }
    }
    const double farthest = std::max(gap, 0.0) + panel.width();
    std::vector<double> distances = cuts_of_exponentials(kernel_.rates, outside, farthest);
    const double off_axis = kernel_.is_regular ? *kernel_.poles : 0;
    if (kernel_.poles) {
      for (const double cut : cuts_of_poles(std::max(*kernel_.poles, outside), off_axis, farthest))
        distances.push_back(cut);
    }
    for (const double cut : distances) {
      for (const double end : {singular - cut, singular + cut})
        if (panel.left < end && end < panel.right) ends.push_back(end);
    }
    std::ranges::sort(ends);
    ends.erase(std::ranges::unique(ends).begin(), ends.end());
    const Integrand integrand{degrees(panel), panel.width(),
                              std::max({slowest_rate, largest(kernel_.rates), largest(rates)}), off_axis,
                              !panel.at_end};
    const bool is_negligible = kernel_.beyond_reach == Kernel::FarAway::negligible;
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (is_negligible && is_beyond_reach(ends[i - 1], ends[i], singular)) continue;
      append_piece(ends[i - 1], ends[i], singular, integrand, mirrored, nodes);
    }
  }

  [[nodiscard]] PanelBasis::Rows basis_at(const Panel& panel, const Nodes& nodes) const {
    const Eigen::ArrayXd from_left = array(nodes.e) - panel.left,
                         from_right = panel.about_middle ? (array(nodes.other) - panel.left).eval()
                                                         : (panel.right - array(nodes.e)).eval();
    return of_.basis(panel).values(from_left / panel.width(), from_right / panel.width(), degrees(panel));
  }

  /// Adds the sums over the nodes to the rows. `with_layers`: the nodes on the leading half resolve the layers, too.
  void add_rows(std::size_t p, const Nodes& nodes, bool trailing, bool with_layers, Rows rows) const {
    const PanelBasis::Rows basis = basis_at(of_.panels_[p], nodes);
    const Eigen::RowVectorXd weight = array(nodes.weight).matrix().transpose();
    Eigen::RowVectorXd signed_weight = weight;
    const auto on_this_half = static_cast<Eigen::Index>(nodes.on_this_half);
    (trailing ? signed_weight.head(on_this_half) : signed_weight.tail(weight.size() - on_this_half)) *= -1;
    const Eigen::ArrayXd alpha = (trailing ? -1 : 1) * array(nodes.alpha);
    Eigen::MatrixXd on_p, on_q;
    kernel_.at({alpha.data(), nodes.alpha.size()}, on_p, on_q);
    for (int i = 0; i < kernel_.functionals; ++i)
      of_.add_sums(p, basis, weight.cwiseProduct(on_p.row(i)), signed_weight.cwiseProduct(on_q.row(i)),
                   rows.row(i));
    if (!with_layers) return;
    const auto leading = trailing ? Eigen::seqN(on_this_half, weight.size() - on_this_half)
                                  : Eigen::seqN(Eigen::Index(0), on_this_half);
    rows.rightCols(of_.layer_columns()) += sums_of_layers(
        on_p(Eigen::all, leading) + on_q(Eigen::all, leading), weight(leading), array(nodes.e)(leading));
  }

  /// Half of a layer is in Re g and half in Im g.
  [[nodiscard]] Eigen::MatrixXd sums_of_layers(const Eigen::MatrixXd& kernels,
                                               const Eigen::RowVectorXd& weight,
                                               const Eigen::ArrayXd& e) const {
    return 0.5 * kernels * weight.asDiagonal() * of_.layers_at(e);
  }

  /// Adds a panel, or its mirror image, by a product rule. Returns false if the kernel is not smooth enough for that.
  bool add_by_product_rule(const Place& place, std::size_t p, bool mirrored, Rows rows) const {
    const Panel& panel = of_.panels_[p];
    const double singular = singular_at(place, mirrored), width = panel.width();
    const double gap = std::max(panel.left - singular, singular - panel.right);
    const Complex off_axis{0, kernel_.is_regular ? *kernel_.poles : 0};
    if (gap <= 0 && off_axis == 0.0) return false;
    if (!kernel_.rates.empty() &&
        (gap < width || width > 8 || oscillates(kernel_.rates, outside(place), gap, width)))
      return false;
    // The kernel's other singularities are farther from the panel. On the ellipse through this singularity the kernel
    // is up to e^(2.1 gap) times as large as on the panel.
    const double fall = internal::log_of_ellipse(2.0 * (singular - panel.left + off_axis) / width - 1.0);
    const double nats = -std::log(tolerance_) + 2.1 * std::max(gap, 0.0);
    const int points = is_linear(panel.left, panel.right, singular) ? 2 : points_of_rule(fall, nats);
    if (points > (gap <= 0 ? most_points_where_analytic : most_points_beside_singularity)) return false;

    const auto rule = product_rule(of_.basis(panel), points, degrees(panel));
    const double sign = (mirrored != place.trailing) ? -1 : 1;
    const Eigen::ArrayXd alpha = sign * ((panel.left - singular) + width * rule->at);
    Eigen::MatrixXd on_p, on_q;
    kernel_.at({alpha.data(), static_cast<std::size_t>(alpha.size())}, on_p, on_q);
    for (int i = 0; i < kernel_.functionals; ++i)
      of_.add_sums(p, rule->weight, width * on_p.row(i), sign * width * on_q.row(i), rows.row(i));
    return true;
  }

  /// Adds the panel that begins at the place by product rules, for a kernel with a logarithm on this side alone.
  /// Returns false for other panels and kernels, and if the kernel's exponentials vary too much over the panel.
  ///
  /// The factor of the logarithm and the rest are analytic within the ellipse through 2 i. On it they grow with the
  /// kernel's exponentials. If the exponentials change by at most e^2 over the panel, the two parts hardly cancel.
  bool add_beside_logarithm(const Place& place, std::size_t p, bool mirrored, Rows rows) const {
    const Panel& panel = of_.panels_[p];
    const double width = panel.width();
    const double rate = largest(kernel_.rates);
    if (!kernel_.by_logarithm || mirrored || place.e != panel.left || rate * width > 2) return false;
    const int points = rounded_up_points(internal::points_of_analytic(width, rate, -std::log(tolerance_)));
    if (points > most_points_where_analytic) return false;
    const auto rule = product_rule(of_.basis(panel), points, degrees(panel)),
               times_logarithm =
                   product_rule(of_.basis(panel), points, degrees(panel), RuleFor::times_logarithm);
    // ln alpha = ln x + ln(width), x from 0 to 1 on the panel.
    const auto [factor, rest] = kernel_.by_logarithm(width * rule->at, width);
    for (int i = 0; i < kernel_.functionals; ++i) {
      const Eigen::RowVectorXd of_logarithm = width * factor.row(i),
                               of_rest = width * rest.row(i) + std::log(width) * of_logarithm;
      if (!of_rest.any()) continue;  // the imaginary part of a memory whose rate is real is 0
      of_.add_sums(p, rule->weight, of_rest, of_rest, rows.row(i));
      of_.add_sums(p, times_logarithm->weight, of_logarithm, of_logarithm, rows.row(i));
    }
    return true;
  }

  const Tractions& of_;
  const Kernel& kernel_;
  double tolerance_;
  double reach_;  ///< the distance beyond which a kernel that decays is below the tolerance
};

// Seen from the matching point s, a load at the node x of the panel, 0 <= x <= 1, is at alpha = width (x - s). There the
// kernel is the sum of -logarithm ln|alpha|/pi, of jump sign(alpha) and of the rest, which is smooth.
bool Tractions::Sums::add_own_panel(std::size_t p, const SplitKernel& split, Eigen::Index first,
                                    MatchingRows& result) const {
  // On much wider panels the logarithm is so much larger than the kernel that the logarithm and the rest cancel.
  constexpr double widest = 24;
  const Panel& panel = of_.panels_[p];
  const double width = panel.width(), log_width = std::log(width);
  if (width > widest) return false;
  const PanelBasis basis = of_.basis(panel);
  const MatchingPoints points = points_of(panel);
  const auto rule = product_rule(
      basis, points_of_rule(internal::log_of_ellipse({0, 4 / width}), -std::log(tolerance_)), degrees(panel));
  const auto singular = singular_integrals(basis, points, degrees(panel));
  // alpha and ln|alpha|: a row for each node and a column for each matching point.
  const Eigen::Index nodes = rule->at.size();
  const auto places = points.at();
  Eigen::ArrayXXd alpha(nodes, points.points);
  for (int j = 0; j < points.points; ++j) alpha.col(j) = width * (rule->at - (*places)(j));
  const Eigen::ArrayXXd logarithm = *logarithms(static_cast<int>(nodes), points) + log_width;
  const auto size = static_cast<std::size_t>(alpha.size());
  Eigen::MatrixXd on_p, on_q;
  split.regular({alpha.data(), size}, {logarithm.data(), size}, on_p, on_q);
  const int terms = panel.terms + left_out;
  for (Eigen::Index functional = 0; functional < kernel_.functionals; ++functional) {
    for (const Summand& sum : summands) {
      if (sum.component >= of_.components() || (rule->weight.*sum.of_basis).size() == 0) continue;
      const Degrees degrees = of_.degrees_of(p, sum.component);
      const auto of_terms = [&](const PanelBasis::Rows& all) {
        return degrees.columns(all.*sum.of_basis, terms);
      };
      const auto rows = Eigen::seqN(first + functional, points.points, kernel_.functionals);
      const auto columns = Eigen::seqN(of_.column(p, sum.component), terms);
      const auto add = [&](double factor, const Eigen::MatrixXd& integrals) {
        result.rows(rows, columns) += factor * integrals;
        result.sizes(rows, columns) += std::fabs(factor) * integrals.cwiseAbs();
      };
      const double scale = sum.sign * degrees.sign * width;
      const Eigen::Index load = sum.is_in_real ? 0 : 1;
      const auto rest = (sum.is_in_real ? on_p : on_q).row(functional).reshaped(nodes, points.points);
      const auto weights = of_terms(rule->weight);
      if (panel.about_middle)
        add(scale, sums_of_halves(rest, weights, sum.is_in_real ? 1 : -1));
      else
        add(scale, product(rest.transpose(), weights));
      // ln|alpha| = ln|x - s| + ln(width)
      if (const double by = -split.logarithm(functional, load) / std::numbers::pi; by != 0) {
        add(scale * by, of_terms(singular->logarithm));
        add(scale * by * log_width, of_terms(singular->one).row(0).replicate(points.points, 1));
      }
      if (const double by = split.jump(functional, load); by != 0) add(scale * by, of_terms(singular->sign));
    }
  }
  return true;
}

Eigen::MatrixXd Tractions::rows(double e, bool trailing, const Kernel& kernel, double tolerance) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(kernel.functionals, columns_);
  Sums(*this, kernel, tolerance).add_place({e, trailing}, panels_.size(), result);
  return result;
}

Eigen::MatrixXd Tractions::rows_of_layers_behind(std::span<const double> places, const Kernel& kernel,
                                                 double tolerance) const {
  const Sums sums(*this, kernel, tolerance);
  Eigen::MatrixXd result(static_cast<Eigen::Index>(places.size()) * kernel.functionals, layer_columns());
  for (Eigen::Index row = 0; const double e : places) {
    result.middleRows(row, kernel.functionals) = sums.layer_rows({e, true});
    row += kernel.functionals;
  }
  return result;
}

Tractions::MatchingRows Tractions::matching_rows(const SplitKernel& kernel, double tolerance) const {
  const Sums sums(*this, kernel.whole, tolerance);
  const int functionals = kernel.whole.functionals;
  MatchingRows result{matching_points(), {}, {}};
  result.rows.setZero(static_cast<Eigen::Index>(result.points.size()) * functionals, columns_);
  result.sizes = result.rows;
  Eigen::Index row = 0;
  for (std::size_t p = 0, at = 0; p < panels_.size(); ++p) {
    const bool is_done = sums.add_own_panel(p, kernel, row, result);
    for (int i = 0; i < points_of(panels_[p]).points; ++i, row += functionals)
      sums.add_place({result.points[at++], false}, is_done ? p : panels_.size(),
                     result.rows.middleRows(row, functionals));
  }
  return result;
}

Eigen::MatrixXd Tractions::integrals_of_layers() const {
  const auto at = [](std::span<const double> alpha, Eigen::MatrixXd& on_p, Eigen::MatrixXd& on_q) {
    on_p.resize(2, static_cast<Eigen::Index>(alpha.size()));
    on_p.row(0).setOnes();
    std::ranges::transform(alpha, on_p.row(1).begin(), std::negate());  // y, seen from the middle
    on_q = on_p;
  };
  const Kernel kernel{2, Kernel::FarAway::varying, {}, at};
  return Sums(*this, kernel, 1e-16).layer_rows({half_length_, false});
}

}  // namespace nipref::fast
