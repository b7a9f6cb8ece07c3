#include <algorithm>

#include <nipref/ref/nip/internal/solved_line_loads.hpp>
#include <nipref/ref/number/interval.hpp>

namespace nipref::ref {

Interval SolvedLineLoads::distance(std::size_t load, const LineLoadPlace& place) const {
  return Interval(place.distance, working_bits()) + length(place.half_elements - half_elements_to(load));
}

Interval SolvedLineLoads::on_roller(const Interval& y) const {
  return indentation - square(y) / (2 * Interval(roller_radius, working_bits()));
}

Interval SolvedLineLoads::moment(int side) const {
  Interval total(working_bits());
  for (std::size_t j = 0; j < normal.size(); ++j) {
    const long place = half_elements_to(j);
    if (side * place > 0) total = total + normal[j] * length(place);
  }
  return total;
}

Interval SolvedLineLoads::load() const {
  Interval sum(working_bits());
  for (const Interval& force : normal) sum = sum + force;
  return sum;
}

Interval SolvedLineLoads::displacement(const LineLoadPlace& place, bool is_normal) const {
  Interval sum(working_bits());
  for (std::size_t load = 0; load < normal.size(); ++load) sum = sum + under(*this, load, place, is_normal);
  return sum;
}

std::optional<bool> SolvedLineLoads::presses_everywhere() const {
  if (std::ranges::any_of(normal, [](const Interval& load) { return sign_of(load) < 0; })) return false;
  if (std::ranges::all_of(normal, [](const Interval& load) { return mpfr_sgn(load.lower()) >= 0; }))
    return true;
  return std::nullopt;
}

std::optional<LineLoadNip> solved_to(
    int digits, const ExtraDigits& extra,
    const std::function<std::optional<SolvedLineLoads>(int influence_digits)>& contact_at,
    const std::function<bool(const SolvedLineLoads&)>& enough) {
  constexpr int spare_digits = 4, rounding_digits = 6;
  for (int more = extra.first; more <= extra.most; more += more) {
    const int working_digits = digits + more + rounding_digits;
    const WorkingDigits scope(working_digits);
    auto contact = contact_at(digits + more);
    if (contact && (enough ? enough(*contact) : contact->error <= pow(Float(10), -(digits + spare_digits))))
      return LineLoadNip(*std::move(contact), digits, working_digits);
  }
  return std::nullopt;
}

namespace {

/// constant + linear x + square x^2.
struct Quadratic {
  Interval constant, linear, square;

  [[nodiscard]] Interval at(const Interval& x) const { return constant + x * (linear + x * square); }
};

bool is_same(const Interval& x, const Interval& y) {
  return mpfr_equal_p(x.lower(), y.lower()) != 0 && mpfr_equal_p(x.upper(), y.upper()) != 0;
}

/// Thrown if the intervals do not decide what the creep is.
struct Undecided {};

int decided_sign(const Interval& x) {
  const int sign = sign_of(x);
  if (sign == 0) throw Undecided();
  return sign;
}

/// The roots of a condition; Undecided if the intervals do not tell how many there are.
std::vector<Interval> roots_of(const Quadratic& f) {
  if (mpfi_is_zero(f.square.get()) > 0) {
    (void)decided_sign(f.linear);
    return {-(f.constant / f.linear)};
  }
  const Interval discriminant = square(f.linear) - 4 * (f.square * f.constant);
  if (decided_sign(discriminant) < 0) return {};
  (void)decided_sign(f.square);
  const Interval root = sqrt(discriminant);
  const Interval q = -(decided_sign(f.linear) > 0 ? f.linear + root : f.linear - root) / 2;
  return {q / f.square, f.constant / q};
}

/// A creep `place` at which condition number `of` is 0.
struct Root {
  Interval place;
  std::size_t of;
};

/// The conditions f >= 0 for the creep, with shear loads that push outwards (sign 1) or inwards (-1). The creep of least
/// magnitude that meets all is 0 or a root of one of them.
class Conditions {
 public:
  Conditions(const std::vector<Interval>& at_zero, const std::vector<Interval>& per_creep, long sign) {
    const std::size_t m = at_zero.size() / 2;
    for (std::size_t k = 0; k < m; ++k) {
      const Interval none(at_zero[k].precision());
      all_.push_back({at_zero[k], per_creep[k], none});
      all_.push_back({sign * at_zero[m + k], sign * per_creep[m + k], none});
    }
    // The shear over the normal load rises outwards.
    for (std::size_t k = 0; k + 1 < m; ++k) {
      const auto product = [&](std::size_t i, std::size_t j) -> Quadratic {
        return {at_zero[i] * at_zero[j], at_zero[i] * per_creep[j] + per_creep[i] * at_zero[j],
                per_creep[i] * per_creep[j]};
      };
      const Quadratic outer = product(m + k + 1, k), inner = product(m + k, k + 1);
      all_.push_back({sign * (outer.constant - inner.constant), sign * (outer.linear - inner.linear),
                      sign * (outer.square - inner.square)});
    }
  }

  /// The creep of least magnitude that meets all conditions, if there is one.
  [[nodiscard]] std::optional<Interval> least() const {
    const Interval zero(all_.front().constant.precision());
    if (is_met(zero, all_.size())) return zero;
    std::optional<Interval> best;
    for (const auto& [root, of] : roots())
      if (is_met(root, of) && (!best || decided_sign(square(*best) - square(root)) > 0)) best = root;
    return best;
  }

  /// The range around `chosen`, which is least(). It ends at the nearest roots on both sides, since all roots are
  /// simple. If `chosen` is a root itself, the range begins there.
  [[nodiscard]] ThesisCreep around(const Interval& chosen) const try {
    ThesisCreep result{chosen};
    for (const auto& [root, of] : roots()) {
      if (is_same(chosen, root)) continue;
      // If the intervals of two roots overlap, the bound covers both.
      const bool is_lower = decided_sign(root - chosen) < 0;
      std::optional<Interval>& nearest = is_lower ? result.lower : result.upper;
      if (!nearest) nearest = root;
      nearest = is_lower ? larger_of(root, *nearest) : -larger_of(-root, -*nearest);
    }
    const int at = sign_of(chosen);
    if (at != 0) (at > 0 ? result.lower : result.upper) = chosen;
    return result;
  } catch (const Undecided&) {
    return {chosen};
  }

 private:
  /// Whether all conditions are met except number `but`, of which x is a root.
  [[nodiscard]] bool is_met(const Interval& x, std::size_t but) const {
    bool is_known = true;
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (k == but) continue;
      const int at_x = sign_of(all_[k].at(x));
      if (at_x < 0) return false;
      if (at_x == 0) is_known = false;
    }
    if (!is_known) throw Undecided();
    return true;
  }

  [[nodiscard]] std::vector<Root> roots() const {
    std::vector<Root> found;
    for (std::size_t k = 0; k < all_.size(); ++k)
      for (const Interval& root : roots_of(all_[k])) found.push_back({root, k});
    return found;
  }

  std::vector<Quadratic> all_;
};

}  // namespace

/// Takes the direction of the shear loads, inwards or outwards, whose creep is nearer to 0.
std::optional<ThesisCreep> thesis_creep(const std::vector<Interval>& at_zero,
                                        const std::vector<Interval>& per_creep) try {
  const Conditions inwards(at_zero, per_creep, -1), outwards(at_zero, per_creep, 1);
  const std::optional<Interval> in = inwards.least(), out = outwards.least();
  if (!in && !out) return std::nullopt;
  const bool is_outwards = !in || (out && decided_sign(square(*in) - square(*out)) > 0);
  return is_outwards ? outwards.around(*out) : inwards.around(*in);
} catch (const Undecided&) {
  return std::nullopt;
}

}  // namespace nipref::ref
