#include <limits>
#include <vector>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/contacts.hpp>
#include <nipref/verify/golden/confirm/history.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify::confirm {
namespace {

/// All results of a contact, in the order of their names.
using Numbers = std::vector<Confirmation>;

Solved rounded(const Float& x) { return Solved(x); }

mpq_class exactly(const Solved& x) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.backend().data());
  return value;
}

std::vector<Confirmation> compared(const char* method, const std::vector<Solved>& fine,
                                   const std::vector<Solved>& coarse) {
  std::vector<Confirmation> result;
  for (std::size_t i = 0; i < fine.size(); ++i)
    result.push_back(confirmation<Solved>(method, fine[i], fine[i] - coarse[i]));
  return result;
}

std::vector<Solved> without_friction(Arguments x, double digits) {
  const Solved half_length = x["L_over_B"], poisson = x["poisson"];
  const Solved beta = (1 - 2 * poisson) / (2 * (1 - poisson));
  const Smooth rest(
      -2 * half_length, 2 * half_length, smooth_points(2 * x["L_over_B"], digits),
      [](const Solved& w) { return rounded(kernel_I1(exactly(w)).value() + log(abs(Float(w)))); });
  const RolledContact contact(
      half_length, [](const Solved&) { return Solved(1); }, [&](const Solved& w) { return rest(w); },
      smooth_points(x["L_over_B"], digits) + 1);
  const Solved stretched = contact.integral(
      [&](const Solved& at) { return rounded(kernel_I3(exactly(Solved(half_length - at))).value()); });
  const Solved square = half_length * half_length;
  return {contact.load() / (8 * square), contact.indentation() / (8 * square),
          (stretched / pi<Solved>() - beta * contact.load() / 2) / (4 * square),
          contact.middle_pressure() / (4 * half_length), 0};
}

/// Longer contacts without friction, or with full friction, need too many points and are not confirmed.
constexpr double longest_confirmed = 4, longest_gripped_confirmed = 0.5;

Numbers elastic_numbers(Arguments x) {
  if (x["L_over_B"] > (x["friction"] == 0 ? longest_confirmed : longest_gripped_confirmed)) {
    const Solved unknown = std::numeric_limits<double>::infinity();
    return Numbers(5, confirmation<Solved>("no rule for so long a contact", 0, unknown));
  }
  if (x["friction"] == 0) {
    return compared("Kress's rule in Chebyshev's singular weight", without_friction(x, 24),
                    without_friction(x, 19));
  }
  return compared("sinc rule", gripped_numbers(x["L_over_B"], x["poisson"], true),
                  gripped_numbers(x["L_over_B"], x["poisson"], false));
}

/// The memory term int_0^inf e^(-rate w) I(x - w) dw of a kernel of the rolling sheet, x downstream. An odd kernel is
/// taken without its term pi/4 sign.
Solved remembered(const Remembered& kernel, const Solved& x, const mpq_class& rate, bool coarse) {
  // The integration variable is v = w - x, so that an odd kernel changes its sign.
  const Float sum = history(kernel, -exactly(x), {}, Complex(to_number<Float>(rate)), coarse).real();
  return rounded(kernel.is_odd ? Float(-sum) : sum);
}

/// int_0^inf rate e^(-rate w) sign(x - w) dw
Solved remembered_sign(const Solved& x, const Solved& rate) {
  return x > 0 ? Solved(1 - 2 * exp(-rate * x)) : Solved(-1);
}

std::vector<Solved> rolling(Arguments x, bool coarse) {
  const Solved half_length = x["L_over_B"];
  // The constants of the material are doubles.
  const double time = x["memory_over_L"] * x["L_over_B"], theta1 = 1 + x["poisson"],
               theta2 = theta1 * (1 - 2 * x["poisson"]), more_soft = x["softening"] - 1;
  const double rates[] = {1 / time, (x["material"] == 0 ? 1 : 2) / time};
  const double amplitudes[] = {theta1 * more_soft / time, theta2 * more_soft / time};
  const Solved compliance = Solved(theta1) + Solved(theta2);
  struct Memory {
    mpq_class rate;    ///< for lengths in half-thicknesses
    Solved amplitude;  ///< divided by the rate and the instantaneous compliance
  };
  std::vector<Memory> memories;  // the last one belongs to theta2
  for (int k = 0; k < 2; ++k) {
    memories.push_back({mpq_class(rates[k]) / 2, Solved(amplitudes[k]) / Solved(rates[k]) / compliance});
  }
  const Solved theta2_memory = memories.back().amplitude;
  if (rates[0] == rates[1]) {
    memories.front().amplitude += theta2_memory;
    memories.pop_back();
  }
  const auto rate = [](const Memory& memory) { return to_number<Solved>(memory.rate); };
  const auto share = [&](const Solved& w) {
    Solved sum = 1;
    for (const Memory& memory : memories) sum -= memory.amplitude * expm1(Solved(-rate(memory) * w));
    return sum;
  };
  const auto normal = [&](const Solved& w) {
    Solved sum = rounded(kernel_I1(exactly(w)).value());
    for (const Memory& memory : memories)
      sum += memory.amplitude * rate(memory) * remembered(remembered_I1, w, memory.rate, coarse);
    return sum;
  };
  // More points, an even number, for the growing exponentials.
  const double growth = 3 * x["L_over_B"] * static_cast<double>(rate(memories.back()));
  const int more = (coarse ? 8 : 16) + 2 * static_cast<int>(growth / 2);
  const Smooth rest(-2 * half_length, 2 * half_length, smooth_points(2 * x["L_over_B"], 11) + more,
                    [&](const Solved& w) { return Solved(normal(w) + share(w) * log(abs(w))); });
  const RolledContact contact(
      half_length, share, [&](const Solved& w) { return rest(w); }, smooth_points(x["L_over_B"], 11) + more);
  // The kernel theta2 * I2 - N * I3.
  const Solved beta = Solved(theta2) / compliance;
  const auto tangential = [&](const Solved& w) {
    const Solved quarter = pi<Solved>() / 4;
    Solved sum = 2 * quarter * beta * (w > 0 ? 1 : -1) - rounded(kernel_I3(exactly(w)).value());
    for (const Memory& memory : memories) {
      sum -= memory.amplitude * (rate(memory) * remembered(remembered_I3, w, memory.rate, coarse) +
                                 quarter * remembered_sign(w, rate(memory)));
    }
    return sum + 2 * quarter * theta2_memory * remembered_sign(w, rate(memories.back()));
  };
  const Solved stretched = contact.integral(
      [&](const Solved& at) { return Solved(tangential(at - half_length) - tangential(at + half_length)); });
  const Solved square = half_length * half_length;
  return {(contact.offset() + contact.moment() / contact.load()) / (2 * half_length),
          (contact.offset() + half_length) / (2 * half_length), contact.load() / (8 * square),
          contact.indentation() / (8 * square), stretched / pi<Solved>() / (8 * square)};
}

Numbers rolling_numbers(Arguments x) {
  return compared("Kress's rule in Chebyshev's singular weight", rolling(x, false), rolling(x, true));
}

/// The quantities of a family, in the order of their numbers.
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

const Methods& nip_methods() {
  static const Methods methods = [] {
    Methods all;
    add_family(all, "nip", elastic_numbers);
    add_family(all, "rolling_nip", rolling_numbers);
    return all;
  }();
  return methods;
}

}  // namespace nipref::verify::confirm
