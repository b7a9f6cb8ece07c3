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

/// The grid in w of sinc collocation: tractions at multiples of the step, slopes of the surface half a step farther.
/// The step follows from the singularities nearest to the real axis of w, the images of the contact's ends in the
/// sheet's faces. Beyond the last node the tractions decay like (A - x)^(1/2 +- i epsilon), as at an end, which
/// neglects terms of the order e^(-3 w).
struct Grid {
  Float step;
  int last, beyond;  ///< last node with unknown tractions; number of nodes beyond it

  Grid(double half_length, double digits) {
    const double strip = (std::atan(2 / half_length) + std::numbers::pi / 2) / 2,
                 nats = digits * std::log(10.0), about = std::numbers::pi * strip / nats;
    step = about;
    last = static_cast<int>(std::ceil(nats / 3 / about));
    beyond = 2 * last;
  }
  [[nodiscard]] Float node(int j) const { return step * j; }
  [[nodiscard]] Float middle(int k) const { return step * k + step / 2; }
};

/// Interpolants of the kernels of the sheet's surface without the term -ln|x|. Lengths are in half-thicknesses.
struct Kernels {
  Interpolant normal, stretch, coupling;  ///< I1 + ln|x|, I6_alpha + ln|x|, I3

  Kernels(double half_length, double digits)
      : normal(made(
            half_length, digits, [](const mpq_class& x) { return I1(x).value(); }, true)),
        stretch(made(
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

/// An elastic contact with full friction by sinc collocation: x = A tanh w, so that the tractions decay in w. The
/// unknowns are the tractions at multiples of a step in w. The pressure is even, the shear odd. The surface's slopes
/// are prescribed half a step away, where the trapezoidal rule converges although the integrals are principal values.
class GrippedContact {
 public:
  GrippedContact(double half_length, double poisson, double digits)
      : half_length_(half_length),
        beta_((1 - 2 * Float(poisson)) / (2 * (1 - Float(poisson)))),
        grid_(half_length, digits),
        kernels_(half_length, digits + 5) {
    const Float turning = 2 * atanh(beta_) / pi();
    for (int m = 0; m <= grid_.beyond; ++m) {
      const Float way = grid_.node(m);
      along_.push_back(exp(-way) * cos(turning * way));
      across_.push_back(exp(-way) * sin(turning * way));
    }
    solve();
  }

  /// Returns nip.load, .indentation, .creep, .peak_pressure, .peak_shear.
  [[nodiscard]] std::vector<Float> numbers() const {
    Float load = 0, depth = 0;
    for (int j = -nodes(); j <= nodes(); ++j) {
      const Float weight = half_length_ * grid_.step / square(cosh(grid_.node(j)));
      // The distance A - x from the end, without cancellation.
      const Float distance = 2 * half_length_ / (exp(2 * grid_.node(j)) + 1);
      load += weight * pressure(j);
      depth += weight * (pressure(j) * (kernels_.normal(distance) - log(distance)) -
                         shear(j) * kernels_.coupling(distance));
    }
    const Float area = square(half_length_);
    return {load / (8 * area), (depth / pi() + area) / (8 * area), strain_ / (4 * half_length_),
            pressure(0) / (4 * half_length_), largest_shear() / (4 * half_length_)};
  }

 private:
  static Float square(const Float& x) { return x * x; }
  [[nodiscard]] int nodes() const { return grid_.last + grid_.beyond; }
  [[nodiscard]] Float pressure(int j) const { return pressure_[at(std::abs(j))]; }
  [[nodiscard]] Float shear(int j) const { return j < 0 ? Float(-shear_[at(-j)]) : shear_[at(j)]; }

  void solve() {
    const int last = grid_.last;
    const auto of_pressure = [](int j) { return std::abs(j); };
    const auto of_shear = [&](int j) { return last + std::abs(j); };
    const int of_strain = 2 * last + 1;
    FloatMatrix system = FloatMatrix::Zero(of_strain + 1, of_strain + 1);
    FloatVector right = FloatVector::Zero(of_strain + 1);
    for (int k = 0; k <= last; ++k) {
      const int slope = k, strain = last + 1 + k;
      const Float w = grid_.middle(k), x = half_length_ * tanh(w);
      for (int j = -last; j <= last; ++j) {
        const int sign = j < 0 ? -1 : 1;
        const Float way(x - half_length_ * tanh(grid_.node(j)));
        // Beyond the last node x hardly changes, so that these slopes are taken as constant.
        const Float normal(kernels_.normal.slope(way)), stretch(kernels_.stretch.slope(way)),
            shared(kernels_.coupling.slope(way));
        for (int m = 0; m <= (std::abs(j) == last ? grid_.beyond : 0); ++m) {
          const Float v = grid_.node(j + sign * m), weight = half_length_ * grid_.step / square(cosh(v));
          const Float singular = -grid_.step * cosh(w) / (cosh(v) * sinh(w - v));
          const Float local = pi() * beta_ * sinc((w - v) / grid_.step), coupling = weight * shared;
          const auto add = [&](int row, const Float& of_p, const Float& of_q) {
            const Float &c = along_[at(m)], &s = across_[at(m)];
            system(row, of_pressure(j)) += c * of_p + s * of_q;
            if (j != 0) system(row, of_shear(j)) += c * of_q - s * of_p;
          };
          add(slope, singular + weight * normal, sign * (local - coupling));
          add(strain, coupling - local, sign * (singular + weight * stretch));
        }
      }
      right(slope) = -2 * pi() * x;
      system(strain, of_strain) = -pi();
    }
    const FloatVector found = system.partialPivLu().solve(right);
    pressure_.assign(found.begin(), found.begin() + last + 1);
    shear_.assign(1, Float(0));
    shear_.insert(shear_.end(), found.begin() + last + 1, found.begin() + 2 * last + 1);
    const Float p = pressure_.back(), q = shear_.back();
    for (int m = 1; m <= grid_.beyond; ++m) {
      pressure_.emplace_back(along_[at(m)] * p - across_[at(m)] * q);
      shear_.emplace_back(across_[at(m)] * p + along_[at(m)] * q);
    }
    strain_ = found(of_strain);
  }

  [[nodiscard]] Float shear_at(const Float& w) const {
    Float sum = 0;
    for (int j = -nodes(); j <= nodes(); ++j) sum += shear(j) * sinc((w - grid_.node(j)) / grid_.step);
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
  /// Beyond the last node, with tractions (p, q), the pressure is along p - across q and the shear across p + along q.
  std::vector<Float> along_, across_;
  std::vector<Float> pressure_, shear_;
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
std::vector<Float> rolling(const RollingSheet& sheet, bool coarse) {
  const Float& half_length = sheet.half_length;
  const auto share = [&](const Float& w) {
    Float sum = 1;
    for (const auto& [rate, memory] : sheet.memories) sum -= memory.of_normal * expm1(-rate * w);
    return sum;
  };
  const auto normal = [&](const Float& w) {
    Float sum = I1(exactly(w)).value();
    for (const auto& [rate, memory] : sheet.memories)
      sum += memory.of_normal * rate * remembered(I1, w, rate, coarse);
    return sum;
  };
  // Because of its growing exponentials a memory needs more points. Their number is even.
  const double reach = half_length.convert_to<double>(), elastic_digits = coarse ? 19 : 24,
               digits = sheet.memories.empty() ? elastic_digits : 11;
  int more = 0;
  for (const auto& [rate, memory] : sheet.memories)
    more =
        std::max(more, (coarse ? 8 : 16) + 2 * static_cast<int>(3 * reach * rate.convert_to<double>() / 2));
  const Interpolant rest(-2 * half_length, 2 * half_length, smooth_points(2 * reach, digits) + more,
                         [&](const Float& w) { return Float(normal(w) + share(w) * log(abs(w))); });
  const RolledContact contact(
      half_length, share, [&](const Float& w) { return rest(w); }, smooth_points(reach, digits) + more);
  // The kernel theta2 * I2 - N * I3.
  const auto tangential = [&](const Float& w) {
    const Float quarter = pi() / 4;
    Float sum = 2 * quarter * sheet.theta2 * (w > 0 ? 1 : -1) - I3(exactly(w)).value();
    for (const auto& [rate, memory] : sheet.memories) {
      const Float step = quarter * remembered_sign(w, rate);
      sum -= memory.of_normal * (rate * remembered(I3, w, rate, coarse) + step);
      sum += 2 * memory.of_theta2 * step;
    }
    return sum;
  };
  const Float stretched = contact.integral(
      [&](const Float& at) { return Float(tangential(at - half_length) - tangential(at + half_length)); });
  const Float square = half_length * half_length;
  return {(contact.offset() + contact.moment() / contact.load()) / (2 * half_length),
          (contact.offset() + half_length) / (2 * half_length),
          contact.load() / (8 * square),
          contact.indentation() / (8 * square),
          stretched / pi() / (8 * square),
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
