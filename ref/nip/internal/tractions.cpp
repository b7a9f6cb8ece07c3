#include <algorithm>
#include <cmath>
#include <utility>

#include <nipref/ref/nip/internal/singular_integrals.hpp>
#include <nipref/ref/nip/internal/tractions.hpp>
#include <nipref/ref/number/internal/chebyshev_sum.hpp>

namespace nipref::ref {
namespace {

using Index = Matrix::Index;

/// In half-thicknesses. The kernels' analytic parts are singular at a distance of 2 from the real axis.
constexpr double longest_piece = 2.5;
/// Distance of a place from a piece, over its width, from which on the piece's nodes integrate the singular kernels.
constexpr double near = 0.5;
/// Logarithm of the factor by which the coefficients of a kernel on a piece fall with each degree, if its singularities
/// are at least `near` widths from the piece or 2 from the real axis.
constexpr double nats_of_degree = 1.25;

/// The values of T_k(2x - 1), k < terms, with a row for each place.
Matrix chebyshev_at(const std::vector<Float>& places, int terms) {
  Matrix values(static_cast<Index>(places.size()), terms);
  std::vector<Float> here(static_cast<std::size_t>(terms));
  for (Index j = 0; j < values.rows(); ++j) {
    chebyshev_values(2 * places[static_cast<std::size_t>(j)] - 1, here);
    for (Index k = 0; k < terms; ++k) values(j, k) = here[static_cast<std::size_t>(k)];
  }
  return values;
}

/// The coefficients of the polynomials that are 1 at one of Chebyshev's points of 0 .. 1, with a row for each point.
Matrix coefficients_by(const std::vector<Float>& points) {
  const int count = static_cast<int>(points.size());
  Matrix coefficients = chebyshev_at(points, count);
  coefficients *= Float(2) / count;
  coefficients.col(0) /= Float(2);
  return coefficients;
}

bool any_has(const std::vector<LineFunctional>& functionals, Influence kind) {
  const auto number = static_cast<std::size_t>(kind);
  return std::ranges::any_of(functionals, [&](const LineFunctional& functional) {
    return functional.on_pressure[number] != 0 || functional.on_shear[number] != 0;
  });
}

}  // namespace

LineFunctional& LineFunctional::pressure(Influence kind, const Float& factor) {
  on_pressure[static_cast<std::size_t>(kind)] = factor;
  return *this;
}
LineFunctional& LineFunctional::shear(Influence kind, const Float& factor) {
  on_shear[static_cast<std::size_t>(kind)] = factor;
  return *this;
}

/// A place relative to the loads of this half, or to their mirror images: a load at e has alpha = side (e - place).
struct Tractions::Image {
  Float place;
  int side;  ///< 1 or -1
  [[nodiscard]] int parity_of_pressure(const LineFunctional& functional) const {
    return side > 0 ? 1 : functional.parity;
  }
  [[nodiscard]] int parity_of_shear(const LineFunctional& functional) const {
    return side > 0 ? 1 : -functional.parity;
  }
};

Tractions::Tractions(const Float& half_length, std::vector<TractionPanel> panels, const Float& epsilon,
                     bool has_shear, double nats)
    : half_length_(half_length),
      epsilon_(epsilon),
      panels_(std::move(panels)),
      has_shear_(has_shear),
      first_columns_{0},
      end_points_(chebyshev_points(static_cast<int>(nats / nats_of_degree) + 6)) {
  int most = 0;
  for (const TractionPanel& panel : panels_) {
    first_columns_.push_back(first_columns_.back() + (has_shear_ ? 2 : 1) * panel.terms);
    most = std::max(most, panel.terms);
  }
  rule_ = gauss_rule(static_cast<int>(nats / (2 * nats_of_degree)) + most / 2 + 6);
  add_end_piece();
  for (std::size_t p = 1; p < panels_.size(); ++p) {
    const TractionPanel& panel = panels_[p];
    const int count = static_cast<int>(std::ceil(static_cast<double>(panel.width) / longest_piece));
    for (int i = 0; i < count; ++i) add_piece(p, panel.left + i * panel.width / count, panel.width / count);
  }
}

void Tractions::add_end_piece() {
  const TractionPanel& panel = panels_.front();
  const Matrix weights = end_weights();
  Nodes nodes;
  for (const Float& x : end_points_) nodes.places.push_back(panel.width * x);
  nodes.real = weights.leftCols(panel.terms).transpose();
  if (epsilon_ != 0) nodes.imaginary = weights.rightCols(panel.terms).transpose();
  pieces_.push_back({0, 0, panel.width, std::move(nodes), {}, {}});
}

void Tractions::add_piece(std::size_t number, const Float& from, const Float& width) {
  const TractionPanel& panel = panels_[number];
  Piece piece{number, from,
              width,  {{}, Matrix(panel.terms, static_cast<Index>(rule_.size())), {}},
              {},     Vector(2 * panel.terms)};
  Nodes& nodes = piece.nodes;
  std::vector<Float> values(static_cast<std::size_t>(panel.terms));
  for (std::size_t j = 0; j < rule_.size(); ++j) {
    nodes.places.push_back(from + width * rule_.from_left[j]);
    chebyshev_values(2 * (nodes.places[j] - panel.left) / panel.width - 1, values);
    for (Index k = 0; k < panel.terms; ++k) {
      Float& here = nodes.real(k, static_cast<Index>(j));
      here = width * rule_.weight[j] * values[static_cast<std::size_t>(k)];
      piece.sums(k) += here;
      piece.sums(panel.terms + k) += here * nodes.places[j];
    }
  }
  if (width != panel.width) {
    const std::vector<Float> points = chebyshev_points(panel.terms);
    std::vector<Float> in_panel;
    for (const Float& x : points) in_panel.push_back((from + width * x - panel.left) / panel.width);
    piece.own = Matrix(chebyshev_at(in_panel, panel.terms).transpose()) * coefficients_by(points);
  }
  pieces_.push_back(std::move(piece));
}

/// The weights at Chebyshev's points with which w T_k times a polynomial is integrated: real parts, then imaginary ones.
Matrix Tractions::end_weights() const {
  const auto nodes = static_cast<Index>(end_points_.size());
  const int terms = panels_.front().terms;
  const Matrix moments = plain_integrals(exponent(0), terms + static_cast<int>(nodes));
  Matrix products(nodes, 2 * terms);
  for (Index l = 0; l < nodes; ++l)
    for (Index k = 0; k < terms; ++k)
      for (Index part : {0, 1})
        products(l, part * terms + k) = moments(l + k, part) + moments(std::abs(l - k), part);
  return panels_.front().width / 2 * (coefficients_by(end_points_) * products);
}

bool Tractions::is_near(const Piece& piece, const Image& image) {
  return abs((image.place - piece.from) / piece.width - Float(1) / 2) < Float(1) / 2 + near;
}

/// The values of a kernel at the nodes of a piece; if the place is near, those of its analytic part.
Vector Tractions::at_nodes(const Piece& piece, const Image& image, Influence kind,
                           SheetKernels& kernels) const {
  const bool near_by = is_near(piece, image);
  Vector values(static_cast<Index>(piece.nodes.places.size()));
  for (Index j = 0; j < values.size(); ++j) {
    const Float alpha = image.side * (piece.nodes.places[static_cast<std::size_t>(j)] - image.place);
    if (kind == Influence::normal) {
      values(j) = near_by ? kernels.smooth_normal(alpha) : kernels.normal(alpha);
    } else if (kind == Influence::sign) {
      values(j) = near_by ? 0 : alpha < 0 ? -1 : 1;
    } else if (kind == Influence::coupling) {
      values(j) = kernels.coupling(alpha);
    } else if (kind == Influence::stretch) {
      values(j) = kernels.stretch(alpha);
    } else if (kind == Influence::normal_slope) {
      values(j) = kernels.smooth_normal_slope(alpha);
      if (!near_by) values(j) -= 1 / alpha;
    } else {
      values(j) = kernels.coupling_slope(alpha);
    }
  }
  return values;
}

/// Adds the integrals of the singular parts of the kernels over a piece near the place.
void Tractions::add_singular(const Piece& piece, const Image& image,
                             const std::vector<LineFunctional>& functionals,
                             std::vector<Vector>& rows) const {
  const bool is_wanted = any_has(functionals, Influence::normal) || any_has(functionals, Influence::sign) ||
                         any_has(functionals, Influence::normal_slope);
  if (!is_wanted) return;
  const int terms = panels_[piece.panel].terms, first = first_columns_[piece.panel];
  const SingularIntegrals own =
      singular_integrals(exponent(piece.panel), (image.place - piece.from) / piece.width, terms);
  const auto add = [&](Influence kind, const Float& factor, const Matrix& of_own) {
    if (!any_has(functionals, kind)) return;
    Matrix integrals = piece.own.size() > 0 ? piece.own * of_own : of_own;
    integrals *= factor;
    for (std::size_t f = 0; f < functionals.size(); ++f) {
      const auto number = static_cast<std::size_t>(kind);
      const Float pressure = image.parity_of_pressure(functionals[f]) * functionals[f].on_pressure[number],
                  shear = image.parity_of_shear(functionals[f]) * functionals[f].on_shear[number];
      if (pressure == 0 && shear == 0) continue;
      rows[f].middleRows(first, terms) += pressure * integrals.col(0) + shear * integrals.col(1);
      if (has_shear_)
        rows[f].middleRows(first + terms, terms) += shear * integrals.col(0) - pressure * integrals.col(1);
    }
  };
  add(Influence::normal, -piece.width, own.logarithm + log(piece.width) * own.plain);
  add(Influence::sign, -image.side * piece.width, own.sign);
  add(Influence::normal_slope, image.side, own.inverse);
}

/// Adds a piece so far from the place that I1 is 0 and the other kernels are lines, constant + slope e.
void Tractions::add_far(const Piece& piece, const Image& image,
                        const std::vector<LineFunctional>& functionals, const Float& level,
                        std::vector<Vector>& rows) const {
  const Float quarter = pi() / 4;
  const int side = piece.from > image.place ? 1 : -1, sign = image.side * side;
  const int terms = panels_[piece.panel].terms, first = first_columns_[piece.panel];
  const auto add = [&](Vector& row, const std::array<Float, influences>& on, int parity, int column) {
    const auto at = [&](Influence kind) -> const Float& { return on[static_cast<std::size_t>(kind)]; };
    const Float& stretch = at(Influence::stretch);
    const Float constant = sign * (at(Influence::sign) + quarter * at(Influence::coupling)) +
                           stretch * (level + side * quarter * image.place),
                slope = -side * quarter * stretch;
    if (constant == 0 && slope == 0) return;
    row.middleRows(column, terms) +=
        Float(parity) * (constant * piece.sums.topRows(terms) + slope * piece.sums.bottomRows(terms));
  };
  for (std::size_t f = 0; f < functionals.size(); ++f) {
    add(rows[f], functionals[f].on_pressure, image.parity_of_pressure(functionals[f]), first);
    if (has_shear_)
      add(rows[f], functionals[f].on_shear, image.parity_of_shear(functionals[f]), first + terms);
  }
}

void Tractions::add_nodes(const Piece& piece, const std::vector<Image>& images,
                          const std::vector<LineFunctional>& functionals, SheetKernels& kernels,
                          std::vector<Vector>& rows) const {
  const Nodes& nodes = piece.nodes;
  const auto count = static_cast<Index>(nodes.places.size());
  std::vector<Vector> on_pressure(functionals.size(), Vector(count)), on_shear = on_pressure;
  for (const Image& image : images) {
    for (int kind = 0; kind < influences; ++kind) {
      const auto number = static_cast<std::size_t>(kind);
      if (!any_has(functionals, static_cast<Influence>(kind))) continue;
      const Vector values = at_nodes(piece, image, static_cast<Influence>(kind), kernels);
      for (std::size_t f = 0; f < functionals.size(); ++f) {
        const Float pressure = image.parity_of_pressure(functionals[f]) * functionals[f].on_pressure[number];
        const Float shear = image.parity_of_shear(functionals[f]) * functionals[f].on_shear[number];
        if (pressure != 0) on_pressure[f] += pressure * values;
        if (shear != 0) on_shear[f] += shear * values;
      }
    }
  }
  const int terms = panels_[piece.panel].terms, first = first_columns_[piece.panel];
  for (std::size_t f = 0; f < functionals.size(); ++f) {
    auto row = rows[f].middleRows(first, has_shear_ ? 2 * terms : terms);
    row.topRows(terms) += nodes.real * on_pressure[f];
    if (has_shear_) row.bottomRows(terms) += nodes.real * on_shear[f];
    if (nodes.imaginary.size() == 0) continue;
    row.topRows(terms) += nodes.imaginary * on_shear[f];
    row.bottomRows(terms) -= nodes.imaginary * on_pressure[f];
  }
}

std::vector<Vector> Tractions::rows(const Float& e, const std::vector<LineFunctional>& functionals,
                                    SheetKernels& kernels) const {
  std::vector<Vector> rows(functionals.size(), Vector(columns()));
  const std::array<Image, 2> images{Image{e, 1}, Image{2 * half_length_ - e, -1}};
  // The constant of the line that -int I3 is far away.
  const Float level = any_has(functionals, Influence::stretch)
                          ? Float(kernels.stretch(kernels.far()) + pi() / 4 * kernels.far())
                          : Float(0);
  for (const Piece& piece : pieces_) {
    // The images near enough for the kernels not to be lines; for the panel at the end, all images.
    std::vector<Image> here;
    for (const Image& image : images) {
      const Float gap =
          std::max(Float(piece.from - image.place), Float(image.place - piece.from - piece.width));
      if (piece.panel == 0 || gap < kernels.far())
        here.push_back(image);
      else
        add_far(piece, image, functionals, level, rows);
    }
    if (!here.empty()) add_nodes(piece, here, functionals, kernels, rows);
    for (const Image& image : images)
      if (is_near(piece, image)) add_singular(piece, image, functionals, rows);
  }
  return rows;
}

std::vector<Float> Tractions::matching_points() const {
  std::vector<Float> points;
  for (std::size_t p = 0; p < panels_.size(); ++p) {
    for (const Float& x : chebyshev_points(panels_[p].terms + (p == 0 ? 1 : 0)))
      points.push_back(panels_[p].left + panels_[p].width * x);
  }
  return points;
}

PressureAndShear Tractions::at(const Float& e, const Vector& coefficients) const {
  std::size_t p = 0;
  while (p + 1 < panels_.size() && e >= panels_[p + 1].left) ++p;
  const TractionPanel& panel = panels_[p];
  const Float x = (e - panel.left) / panel.width, place = 2 * x - 1;
  const auto sum_from = [&](int column) {
    return chebyshev_sum({coefficients.data() + column, static_cast<std::size_t>(panel.terms)}, place);
  };
  const Float a = sum_from(first_columns_[p]),
              b = has_shear_ ? sum_from(first_columns_[p] + panel.terms) : Float(0);
  if (p > 0) return {a, b};
  if (!(x > 0)) return {0, 0};
  const Float size = sqrt(x);
  if (epsilon_ == 0) return {size * a, size * b};
  const Float phase = epsilon_ * log(x);
  const Float real = size * cos(phase), imaginary = -size * sin(phase);
  return {real * a - imaginary * b, real * b + imaginary * a};
}

PressureAndShear Tractions::at_root(const Vector& coefficients) const {
  PressureAndShear result{0, 0};
  const int terms = panels_.front().terms;
  for (Index k = 0; k < terms; ++k) {
    const int sign = k % 2 == 0 ? 1 : -1;
    result.pressure += sign * coefficients(k);
    if (has_shear_) result.shear += sign * coefficients(terms + k);
  }
  return result;
}

Vector Tractions::weighted(const std::function<Float(const Float&)>& factor) const {
  Vector row(columns());
  for (const Piece& piece : pieces_) {
    const auto& [places, real, imaginary] = piece.nodes;
    const int first = first_columns_[piece.panel];
    Vector factors(real.cols());
    for (Index j = 0; j < factors.size(); ++j) factors(j) = factor(places[static_cast<std::size_t>(j)]);
    row.middleRows(first, real.rows()) += real * factors;
    if (imaginary.size() > 0) row.middleRows(first + real.rows(), real.rows()) -= imaginary * factors;
  }
  return row;
}

Vector Tractions::integral() const {
  return weighted([](const Float&) { return Float(1); });
}

Vector Tractions::moment() const {
  return weighted([&](const Float& e) -> Float { return half_length_ - e; });
}

}  // namespace nipref::ref
