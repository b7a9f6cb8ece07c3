#include <Eigen/Dense>
#include <boost/multiprecision/eigen.hpp>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/interpolant.hpp>
#include <nipref/verify/golden/confirm/kernels.hpp>
#include <nipref/verify/golden/confirm/nip.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify::confirm {
namespace {

using FloatMatrix = Eigen::Matrix<Float, Eigen::Dynamic, Eigen::Dynamic>;
using FloatVector = Eigen::Matrix<Float, Eigen::Dynamic, 1>;

std::size_t at(long i) { return static_cast<std::size_t>(i); }

/// Returns the number of Chebyshev points, an even one, that interpolate a function on (-reach, reach) to `digits`
/// digits. The singularities of the function are at least 2 away from the real axis.
int smooth_points(double reach, double digits) {
  const double height = 2 / reach, ellipse = height + std::hypot(1, height);
  return 2 * static_cast<int>(8 + digits * std::log(10.0) / std::log(ellipse) / 2);
}

/// The grid in w of sinc collocation: tractions at the nodes, multiples of the step, and slopes of the surface at the
/// midpoints between them. The step follows from the singularities nearest to the real axis of w, the images of the
/// contact's ends in the sheet's faces. Beyond the last node with unknown tractions there are nodes of a tail, on which
/// the tractions decay like (A - x)^(1/2 +- i epsilon), as at an end. This neglects terms of the order e^(-3 w).
struct Grid {
  Float step;
  int last, tail;  ///< last node with unknown tractions; number of nodes beyond it

  Grid(double half_length, double digits) {
    const double strip = (std::atan(2 / half_length) + std::numbers::pi / 2) / 2,
                 nats = digits * std::log(10.0), about = std::numbers::pi * strip / nats;
    step = about;
    last = static_cast<int>(std::ceil(nats / 3 / about));
    tail = 2 * last;
  }
  [[nodiscard]] Float node(int j) const { return step * j; }
  [[nodiscard]] Float midpoint(int k) const { return step * k + step / 2; }
};

/// Interpolants of the kernels of the sheet's surface without the term -ln|x|. Lengths are in half-thicknesses.
struct Kernels {
  Interpolant normal, tangential, coupling;  ///< I1 + ln|x|, I6_alpha + ln|x|, I3

  Kernels(double half_length, double digits)
      : normal(made(
            half_length, digits, [](const mpq_class& x) { return I1(x).value(); }, true)),
        tangential(made(
            half_length, digits, [](const mpq_class& x) { return I6_alpha(x).value(); }, true)),
        coupling(made(
            half_length, digits, [](const mpq_class& x) { return I3(x).value(); }, false)) {}

  template <class Kernel>
  static Interpolant made(double half_length, double digits, const Kernel& kernel, bool has_logarithm) {
    return {Float(-2 * half_length), Float(2 * half_length), smooth_points(2 * half_length, digits),
            [&](const Float& x) {
              const Float value = kernel(exactly(x));
              return Float(has_logarithm ? Float(value + log(abs(x))) : value);
            }};
  }
};

Float sinc(const Float& x) {
  if (x == 0) return 1;
  const Float angle = pi() * x;
  return sin(angle) / angle;
}

/// An elastic contact with full friction by sinc collocation. Lengths are in half-thicknesses b, displacements in
/// b^2/(2 R). x points from the middle of the contact to its end x = A. The pressure p is even, the shear q odd. At x,
/// with t = x - s, they cause the normal displacement u and the tangential displacement v:
///   pi u = int p(s) I1(t) - q(s) (I3(t) - beta I2(t)) ds
///   pi v = int q(s) I6_alpha(t) + p(s) (I3(t) - beta I2(t)) ds
/// where beta = theta2/N and I2(t) = pi/2 sign t. In the contact u' = -2 x, and v' is a constant, the unknown strain.
/// I1 and I6_alpha contain -ln|t|, whose derivative makes the integrals of u' and v' principal values.
///
/// With x = A tanh w and s = A tanh v the tractions decay in w, and the unknowns are their values at the nodes. The two
/// slopes are prescribed at the midpoints, where the trapezoidal rule converges although the integrals are principal
/// values.
class GrippedContact {
 public:
  GrippedContact(double half_length, double poisson, double digits)
      : half_length_(half_length),
        beta_((1 - 2 * Float(poisson)) / (2 * (1 - Float(poisson)))),
        grid_(half_length, digits),
        kernels_(half_length, digits + 5) {
    const Float turning = 2 * atanh(beta_) / pi();
    for (int m = 0; m <= grid_.tail; ++m) {
      const Float beyond = grid_.node(m);
      tail_cos_.push_back(exp(-beyond) * cos(turning * beyond));
      tail_sin_.push_back(exp(-beyond) * sin(turning * beyond));
    }
    solve();
  }

  /// Returns nip.load, .indentation, .creep, .peak_pressure, .peak_shear.
  [[nodiscard]] std::vector<Float> numbers() const {
    Float load = 0, displacement = 0;  // of the end x = A, times pi; the integral of q I2 is 0 there
    for (int j = -tail_end(); j <= tail_end(); ++j) {
      const Float weight = half_length_ * grid_.step / square(cosh(grid_.node(j)));
      // The distance A - s, without cancellation.
      const Float distance = 2 * half_length_ / (exp(2 * grid_.node(j)) + 1);
      load += weight * pressure(j);
      displacement += weight * (pressure(j) * (kernels_.normal(distance) - log(distance)) -
                                shear(j) * kernels_.coupling(distance));
    }
    const Float half_squared = square(half_length_);
    return {load / (8 * half_squared), (displacement / pi() + half_squared) / (8 * half_squared),
            strain_ / (4 * half_length_), pressure(0) / (4 * half_length_),
            largest_shear() / (4 * half_length_)};
  }

 private:
  static Float square(const Float& x) { return x * x; }
  [[nodiscard]] int tail_end() const { return grid_.last + grid_.tail; }
  [[nodiscard]] Float pressure(int j) const { return pressure_[at(std::abs(j))]; }
  [[nodiscard]] Float shear(int j) const { return j < 0 ? Float(-shear_[at(-j)]) : shear_[at(j)]; }

  /// Solves a linear system of pi u' and pi v' at the midpoints of one half. Its unknowns are the pressures and shears
  /// at the nodes of that half, and the strain.
  void solve() {
    const int last = grid_.last, strain_column = 2 * last + 1;
    const auto pressure_column = [](int j) { return std::abs(j); };
    const auto shear_column = [&](int j) { return last + std::abs(j); };  // the shear at node 0 is 0
    FloatMatrix system = FloatMatrix::Zero(strain_column + 1, strain_column + 1);
    FloatVector right = FloatVector::Zero(strain_column + 1);
    for (int k = 0; k <= last; ++k) {
      const int normal_row = k, tangential_row = last + 1 + k;
      const Float w = grid_.midpoint(k), x = half_length_ * tanh(w);
      for (int j = -last; j <= last; ++j) {
        const int sign = j < 0 ? -1 : 1;  // the shear at node j is `sign` times its unknown
        const Float t(x - half_length_ * tanh(grid_.node(j)));
        // On the tail s hardly changes, so that these slopes are taken as constant there.
        const Float normal(kernels_.normal.slope(t)), tangential(kernels_.tangential.slope(t)),
            coupling(kernels_.coupling.slope(t));
        for (int m = 0; m <= (std::abs(j) == last ? grid_.tail : 0); ++m) {
          const Float v = grid_.node(j + sign * m), weight = half_length_ * grid_.step / square(cosh(v));
          // The weight times -1/t, the derivative of -ln|t|, without cancellation.
          const Float singular = -grid_.step * cosh(w) / (cosh(v) * sinh(w - v));
          // beta I2 has the derivative pi beta delta(t): the sinc function gives the traction at the midpoint.
          const Float local = pi() * beta_ * sinc((w - v) / grid_.step), coupled = weight * coupling;
          // The tractions m nodes beyond node j follow from those at node j. Adds the effects of unit tractions there.
          const auto add = [&](int row, const Float& of_pressure, const Float& of_shear) {
            const Float &c = tail_cos_[at(m)], &s = tail_sin_[at(m)];
            system(row, pressure_column(j)) += c * of_pressure + s * of_shear;
            if (j != 0) system(row, shear_column(j)) += c * of_shear - s * of_pressure;
          };
          add(normal_row, singular + weight * normal, sign * (local - coupled));
          add(tangential_row, coupled - local, sign * (singular + weight * tangential));
        }
      }
      right(normal_row) = -2 * pi() * x;
      system(tangential_row, strain_column) = -pi();
    }
    const FloatVector found = system.partialPivLu().solve(right);
    pressure_.assign(found.begin(), found.begin() + last + 1);
    shear_.assign(1, Float(0));
    shear_.insert(shear_.end(), found.begin() + last + 1, found.begin() + strain_column);
    const Float p = pressure_.back(), q = shear_.back();
    for (int m = 1; m <= grid_.tail; ++m) {
      pressure_.emplace_back(tail_cos_[at(m)] * p - tail_sin_[at(m)] * q);
      shear_.emplace_back(tail_sin_[at(m)] * p + tail_cos_[at(m)] * q);
    }
    strain_ = found(strain_column);
  }

  [[nodiscard]] Float shear_at(const Float& w) const {
    Float sum = 0;
    for (int j = -tail_end(); j <= tail_end(); ++j) sum += shear(j) * sinc((w - grid_.node(j)) / grid_.step);
    return abs(sum);
  }
  /// Returns the largest shear, by golden-section search about the node with the largest value.
  [[nodiscard]] Float largest_shear() const {
    int largest = 1;
    for (int j = 1; j < grid_.last; ++j)
      if (abs(shear(j)) > abs(shear(largest))) largest = j;
    const Float part = (sqrt(Float(5)) - 1) / 2;
    Float from = grid_.node(largest - 1), to = grid_.node(largest + 1);
    for (int i = 0; i < 60; ++i) {
      const Float left = to - part * (to - from), right = from + part * (to - from);
      (shear_at(left) < shear_at(right) ? from : to) = shear_at(left) < shear_at(right) ? left : right;
    }
    return shear_at((from + to) / 2);
  }

  Float half_length_, beta_;
  Grid grid_;
  Kernels kernels_;
  /// m nodes beyond the last one, with tractions (p, q), the pressure is cos p - sin q and the shear sin p + cos q. The
  /// angle of these two grows with m, and both decay.
  std::vector<Float> tail_cos_, tail_sin_;
  std::vector<Float> pressure_, shear_;  ///< at the nodes from 0 to the end of the tail
  Float strain_;
};

/// A frictionless contact by Kress's rule. The pressure is g(t)/sqrt(1 - t^2), where g is given by its values at the
/// zeros of T_n. The product of the kernel's logarithm and T_j is integrated exactly, the rest by the Gauss-Chebyshev
/// rule. Two more equations, g(+-1) = 0 for a bounded pressure, determine the position and the depth of the contact.
/// Lengths are in half-thicknesses b, and the pressure in b/(2 R N_0). x points from the middle of the contact to its
/// leading end.
class RolledContact {
 public:
  /// `half_length` is A > 0, and `points` > 3. At the distance x downstream of a unit load the displacement of the
  /// surface times pi is share(x) (-ln|x|) + rest(x), where both functions are analytic.
  RolledContact(const Float& half_length, const std::function<Float(const Float& x)>& share,
                const std::function<Float(const Float& x)>& rest, int points)
      : half_length_(half_length), nodes_(points) {
    const Float half_turn = pi(), step = half_turn / points;
    // waves: T_j at each node. by_values: the matrix from values at the nodes to Chebyshev coefficients.
    FloatMatrix waves(points, points), by_values(points, points);
    FloatVector of_logarithm(points), alternating(points);
    for (int j = 0; j < points; ++j) {
      for (int k = 0; k < points; ++k) {
        waves(k, j) = cos(Float(j * (2 * k + 1) * step / 2));
        by_values(j, k) = (j == 0 ? 1 : 2) * waves(k, j) / points;
      }
      // The integral of -ln|t - s| T_j(s)/sqrt(1 - s^2) is a multiple of T_j(t).
      of_logarithm(j) = j == 0 ? Float(half_turn * log(Float(2))) : Float(half_turn / j);
      alternating(j) = j % 2 == 0 ? 1 : -1;
    }
    nodes_ = waves.col(1);
    const FloatMatrix logarithm = (waves * of_logarithm.asDiagonal()).lazyProduct(by_values);
    FloatMatrix system = FloatMatrix::Zero(points + 2, points + 2);
    FloatVector right = FloatVector::Zero(points + 2);
    for (int k = 0; k < points; ++k) {
      for (int i = 0; i < points; ++i) {
        const Float x = half_length_ * (nodes_(i) - nodes_(k));
        system(k, i) =
            half_length_ * (share(x) * (logarithm(k, i) - log(half_length_) * step) + rest(x) * step);
      }
      // The right side is D + slope t - (A t)^2.
      system(k, points) = -half_turn;
      system(k, points + 1) = -half_turn * nodes_(k);
      right(k) = -half_turn * half_length_ * half_length_ * nodes_(k) * nodes_(k);
    }
    system.row(points).head(points) = by_values.colwise().sum();
    system.row(points + 1).head(points) = alternating.transpose().lazyProduct(by_values);
    const FloatVector found = system.partialPivLu().solve(right);
    values_ = found.head(points);
    for (int j = 0; j < points; j += 2)
      middle_pressure_ += (j % 4 == 0 ? 1 : -1) * by_values.row(j).dot(values_);
    // D + slope t - (A t)^2 = d0 - (offset + A t)^2, where d0 is the indentation.
    offset_ = -found(points + 1) / (2 * half_length_);
    indentation_ = found(points) + offset_ * offset_;
  }

  [[nodiscard]] Float load() const {
    return integral([](const Float&) { return Float(1); });
  }
  [[nodiscard]] Float offset() const { return offset_; }            ///< of the middle from the roller's axis
  [[nodiscard]] Float indentation() const { return indentation_; }  ///< in b^2/(2 R)
  /// The moment of the pressure about the contact's middle.
  [[nodiscard]] Float moment() const {
    return integral([](const Float& x) { return x; });
  }
  [[nodiscard]] Float middle_pressure() const { return middle_pressure_; }
  /// The integral of the pressure times f(x).
  [[nodiscard]] Float integral(const auto& f) const {
    Float sum = 0;
    for (int i = 0; i < nodes_.size(); ++i) sum += values_(i) * f(half_length_ * nodes_(i));
    return sum * half_length_ * pi() / nodes_.size();
  }

 private:
  Float half_length_, offset_, indentation_, middle_pressure_ = 0;
  FloatVector nodes_, values_;
};

using Numbers = std::vector<Confirmation>;

std::vector<Confirmation> compared(const char* method, const std::vector<Float>& fine,
                                   const std::vector<Float>& coarse) {
  std::vector<Confirmation> result;
  for (std::size_t i = 0; i < fine.size(); ++i)
    result.push_back(confirmation(method, fine[i], fine[i] - coarse[i]));
  return result;
}

/// The memory term int_0^inf e^(-rate w) I(x - w) dw of a kernel of the rolling sheet, x downstream. An odd kernel is
/// taken without its term pi/4 sign.
Float remembered(const SymbolTransform& kernel, const Float& x, const Float& rate, bool coarse) {
  // The integration variable is v = w - x, so that an odd kernel changes its sign.
  const Float sum = history(kernel, -exactly(x), {}, Complex(rate), coarse).real();
  return kernel.is_odd ? Float(-sum) : sum;
}

/// int_0^inf rate e^(-rate w) sign(x - w) dw
Float remembered_sign(const Float& x, const Float& rate) {
  return x > 0 ? Float(1 - 2 * exp(-rate * x)) : Float(-1);
}

/// Computes the numbers of rolling_numbers() by a fine or a coarse rule. A sheet without memory is elastic.
///
/// A unit load causes the normal displacement normal(x)/pi at the distance x downstream of it. normal(x) is I1(x) plus,
/// for each memory, of_normal rate int_0^inf e^(-rate w) I1(x - w) dw. As I1(x) contains -ln|x|, normal(x) contains
/// -share(x) ln|x|, where share(x) is 1 plus, for each memory, of_normal (1 - e^(-rate x)).
std::vector<Float> rolling(const RollingSheet& sheet, bool coarse) {
  const Float& half_length = sheet.half_length;
  const auto share = [&](const Float& x) {
    Float sum = 1;
    for (const auto& [rate, memory] : sheet.memories) sum -= memory.of_normal * expm1(-rate * x);
    return sum;
  };
  const auto normal = [&](const Float& x) {
    Float sum = I1(exactly(x)).value();
    for (const auto& [rate, memory] : sheet.memories)
      sum += memory.of_normal * rate * remembered(I1, x, rate, coarse);
    return sum;
  };
  // Upstream of a load, e^(-rate x) grows, so that a memory needs more points. Their number is even.
  const double half = half_length.convert_to<double>(), elastic_digits = coarse ? 19 : 24,
               digits = sheet.memories.empty() ? elastic_digits : 11;
  int extra = 0;
  for (const auto& [rate, memory] : sheet.memories)
    extra =
        std::max(extra, (coarse ? 8 : 16) + 2 * static_cast<int>(3 * half * rate.convert_to<double>() / 2));
  const Interpolant smooth_part(-2 * half_length, 2 * half_length, smooth_points(2 * half, digits) + extra,
                                [&](const Float& x) { return Float(normal(x) + share(x) * log(abs(x))); });
  const RolledContact contact(
      half_length, share, [&](const Float& x) { return smooth_part(x); },
      smooth_points(half, digits) + extra);
  // The tangential displacement under a unit load times pi: the kernel theta2 I2 - N I3 and its memories, where I2 is
  // pi/2 sign x. remembered(I3) lacks the term pi/4 sign x, whose memory is `jump`.
  const auto tangential = [&](const Float& x) {
    const Float quarter = pi() / 4;
    Float sum = 2 * quarter * sheet.theta2 * (x > 0 ? 1 : -1) - I3(exactly(x)).value();
    for (const auto& [rate, memory] : sheet.memories) {
      const Float jump = quarter * remembered_sign(x, rate);
      sum -= memory.of_normal * (rate * remembered(I3, x, rate, coarse) + jump);
      sum += 2 * memory.of_theta2 * jump;
    }
    return sum;
  };
  // The tangential displacement of the leading end less that of the trailing end, times pi.
  const Float stretched = contact.integral(
      [&](const Float& at) { return Float(tangential(at - half_length) - tangential(at + half_length)); });
  const Float half_squared = half_length * half_length;
  return {(contact.offset() + contact.moment() / contact.load()) / (2 * half_length),
          (contact.offset() + half_length) / (2 * half_length),
          contact.load() / (8 * half_squared),
          contact.indentation() / (8 * half_squared),
          stretched / pi() / (8 * half_squared),
          contact.middle_pressure() / (4 * half_length)};
}

Numbers elastic_numbers(Arguments x) {
  if (x["L_over_B"] > (x["friction"] == 0 ? longest_confirmed : longest_gripped_confirmed)) {
    const Float unknown = std::numeric_limits<double>::infinity();
    return Numbers(5, confirmation("no rule for so long a contact", Float(0), unknown));
  }
  if (x["friction"] != 0)
    return compared("sinc rule", GrippedContact(x["L_over_B"], x["poisson"], 21).numbers(),
                    GrippedContact(x["L_over_B"], x["poisson"], 19).numbers());
  const Float poisson = x["poisson"];
  const Numbers all = rolling_numbers({x["L_over_B"], (1 - 2 * poisson) / (2 - 2 * poisson)});
  return {all[2], all[3], all[4], all[5], confirmation(all[5].method, Float(0), Float(0))};
}

/// The sheet of the quantities rolling_nip.*. Its constants are rounded to double, as those of the catalogue are.
RollingSheet rolling_sheet(Arguments x) {
  const double time = x["memory_over_L"] * x["L_over_B"], theta1 = 1 + x["poisson"],
               theta2 = theta1 * (1 - 2 * x["poisson"]), more_soft = x["softening"] - 1;
  const Float compliance = Float(theta1) + theta2;
  RollingSheet sheet{x["L_over_B"], theta2 / compliance};
  const auto remember = [&](double at_once, double rate, bool is_theta2) {
    sheet.remember(Float(rate) / 2, at_once * more_soft / time / Float(rate) / compliance, is_theta2);
  };
  remember(theta1, 1 / time, false);
  remember(theta2, (x["material"] == 0 ? 1 : 2) / time, true);
  return sheet;
}

/// Adds the methods of a family. `solve` returns the numbers in the order of the family's quantities in the catalogue.
void add_family(Methods& methods, std::string_view family, Numbers (*solve)(Arguments)) {
  std::size_t next = 0;
  for (const Quantity& quantity : catalogue()) {
    if (quantity.family != family) continue;
    methods[quantity.name] = [i = next++, solve](Arguments x) {
      static Cache<std::vector<double>, Numbers> solved;
      const std::span<const double> point = x.from("L_over_B");
      return (*solved.at({point.begin(), point.end()}, [&] { return solve(x); }))[i];
    };
  }
}

}  // namespace

Numbers rolling_numbers(const RollingSheet& sheet) {
  return compared("Kress's rule in Chebyshev's singular weight", rolling(sheet, false), rolling(sheet, true));
}

Methods nip_methods() {
  Methods all;
  add_family(all, "nip", elastic_numbers);
  add_family(all, "rolling_nip", [](Arguments x) { return rolling_numbers(rolling_sheet(x)); });
  return all;
}

}  // namespace nipref::verify::confirm
