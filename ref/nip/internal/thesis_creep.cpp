#include <utility>

#include <nipref/ref/nip/internal/thesis_creep.hpp>
#include <nipref/ref/number/internal/float_interval.hpp>

namespace nipref::ref {
namespace {

/// constant + linear x + square x^2.
struct Quadratic {
  Interval constant, linear, square;

  [[nodiscard]] Interval at(const Interval& x) const { return constant + x * (linear + x * square); }
};

/// The sign, -1 or 1; 0 if the interval contains 0.
int sign(const Interval& x) {
  if (mpfr_sgn(x.lower()) > 0) return 1;
  return mpfr_sgn(x.upper()) < 0 ? -1 : 0;
}

bool is_zero(const Interval& x) { return mpfr_zero_p(x.lower()) != 0 && mpfr_zero_p(x.upper()) != 0; }

/// The numbers that satisfy every condition f >= 0. The one of least magnitude is 0 or a root of one of the conditions.
class Conditions {
 public:
  void require(Quadratic f) { all_.push_back(std::move(f)); }

  /// The number of least magnitude, or none if there is none; nothing if the intervals do not decide.
  [[nodiscard]] std::optional<std::optional<Interval>> least() const {
    if (all_.empty()) return std::nullopt;
    const Interval zero(all_.front().constant.precision());
    const std::optional<bool> at_zero = met(zero, all_.size());
    if (!at_zero) return std::nullopt;
    if (*at_zero) return std::optional(zero);
    std::optional<Interval> best;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const auto roots = roots_of(all_[k]);
      if (!roots) return std::nullopt;
      for (const Interval& root : *roots) {
        const std::optional<bool> is_met = met(root, k);
        if (!is_met) return std::nullopt;
        if (!*is_met) continue;
        if (!best) {
          best = root;
          continue;
        }
        const int nearer = sign(square(*best) - square(root));
        if (nearer == 0) return std::nullopt;
        if (nearer > 0) best = root;
      }
    }
    return best;
  }

  /// The range of numbers around `chosen`, which is least(), that satisfy all conditions. It ends at the nearest
  /// roots on both sides, since all roots are simple. If `chosen` is a root itself, the range begins there.
  [[nodiscard]] std::optional<ThesisCreepRange> around(const Interval& chosen) const {
    std::optional<Interval> below, above;
    for (const Quadratic& condition : all_) {
      const auto roots = roots_of(condition);
      if (!roots) return std::nullopt;
      for (const Interval& root : *roots) {
        if (is_root(chosen, root)) continue;
        const int side = sign(root - chosen);
        if (side == 0) return std::nullopt;
        std::optional<Interval>& nearest = side < 0 ? below : above;
        // If the intervals of two roots overlap, the bound covers both.
        const auto nearer = [&](const Interval& other) {
          return side < 0 ? larger_of(root, other) : -larger_of(-root, -other);
        };
        nearest = nearest ? nearer(*nearest) : root;
      }
    }
    const int at = sign(chosen);
    if (at > 0) below = chosen;
    if (at < 0) above = chosen;
    if (!below || !above) return std::nullopt;
    return ThesisCreepRange{*below, *above, chosen};
  }

 private:
  /// Whether x is the same interval as the root.
  static bool is_root(const Interval& x, const Interval& root) {
    return mpfr_equal_p(x.lower(), root.lower()) != 0 && mpfr_equal_p(x.upper(), root.upper()) != 0;
  }

  /// Whether x satisfies all conditions except number `but`, of which it is a root; nothing if the intervals do not
  /// decide.
  [[nodiscard]] std::optional<bool> met(const Interval& x, std::size_t but) const {
    bool is_known = true;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (k == but) continue;
      const int at_x = sign(all_[k].at(x));
      if (at_x < 0) return false;
      if (at_x == 0) is_known = false;
    }
    return is_known ? std::optional(true) : std::nullopt;
  }

  static std::optional<std::vector<Interval>> roots_of(const Quadratic& f) {
    if (is_zero(f.square)) {
      if (sign(f.linear) == 0) return std::nullopt;
      return std::vector{-(f.constant / f.linear)};
    }
    const Interval discriminant = square(f.linear) - 4 * (f.square * f.constant);
    const int has_roots = sign(discriminant);
    if (has_roots < 0) return std::vector<Interval>{};
    if (has_roots == 0 || sign(f.square) == 0 || sign(f.linear) == 0) return std::nullopt;
    const Interval root = sqrt(discriminant);
    const Interval q = -(sign(f.linear) > 0 ? f.linear + root : f.linear - root) / 2;
    return std::vector{q / f.square, f.constant / q};
  }

  std::vector<Quadratic> all_;
};

/// (a + b x) (c + d x) - (e + f x) (g + h x)
Quadratic difference_of_products(const Interval& a, const Interval& b, const Interval& c, const Interval& d,
                                 const Interval& e, const Interval& f, const Interval& g, const Interval& h) {
  return {a * c - e * g, a * d + b * c - (e * h + f * g), b * d - f * h};
}

/// With shear loads that push outwards (sign 1) or inwards (-1).
Conditions conditions(const std::vector<Interval>& at_zero, const std::vector<Interval>& per_creep,
                      long sign) {
  const std::size_t m = at_zero.size() / 2;
  const Interval none(at_zero.front().precision());
  Conditions result;
  for (std::size_t k = 0; k < m; ++k) {
    result.require({at_zero[k], per_creep[k], none});
    result.require({sign * at_zero[m + k], sign * per_creep[m + k], none});
  }
  for (std::size_t k = 0; k + 1 < m; ++k) {
    Quadratic rise =
        difference_of_products(at_zero[m + k + 1], per_creep[m + k + 1], at_zero[k], per_creep[k],
                               at_zero[m + k], per_creep[m + k], at_zero[k + 1], per_creep[k + 1]);
    result.require({sign * rise.constant, sign * rise.linear, sign * rise.square});
  }
  return result;
}

/// The conditions of the sign of the shear loads whose creep is nearer to 0, and that creep.
struct Chosen {
  Conditions conditions;
  Interval creep;
};

std::optional<Chosen> chosen_of(const std::vector<Interval>& at_zero,
                                const std::vector<Interval>& per_creep) {
  Conditions inwards = conditions(at_zero, per_creep, -1), outwards = conditions(at_zero, per_creep, 1);
  const auto in = inwards.least(), out = outwards.least();
  if (!in || !out || (!*in && !*out)) return std::nullopt;
  if (!*in || !*out) return *in ? Chosen{std::move(inwards), **in} : Chosen{std::move(outwards), **out};
  const int nearer = sign(square(**in) - square(**out));
  if (nearer == 0) return std::nullopt;
  return nearer > 0 ? Chosen{std::move(outwards), **out} : Chosen{std::move(inwards), **in};
}

}  // namespace

std::optional<Interval> thesis_creep(const std::vector<Interval>& at_zero,
                                     const std::vector<Interval>& per_creep) {
  const auto chosen = chosen_of(at_zero, per_creep);
  return chosen ? std::optional(chosen->creep) : std::nullopt;
}

std::optional<ThesisCreepRange> thesis_creep_range(const std::vector<Interval>& at_zero,
                                                   const std::vector<Interval>& per_creep) {
  const auto chosen = chosen_of(at_zero, per_creep);
  return chosen ? chosen->conditions.around(chosen->creep) : std::nullopt;
}

}  // namespace nipref::ref
