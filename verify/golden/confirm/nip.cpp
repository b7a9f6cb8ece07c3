#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <nipref/verify/golden/confirm/gripped_contact.hpp>
#include <nipref/verify/golden/confirm/history.hpp>
#include <nipref/verify/golden/confirm/nip.hpp>
#include <nipref/verify/golden/confirm/rolled_contact.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify::confirm {
namespace {

using Arguments = std::span<const double>;
/// All numbers of a contact, in the order of their names.
using Numbers = std::vector<Confirmation>;

constexpr std::array<std::string_view, 5> elastic_names{"nip.load", "nip.indentation", "nip.creep",
                                                        "nip.peak_pressure", "nip.peak_shear"};
constexpr std::array<std::string_view, 5> rolling_names{"rolling_nip.resistance", "rolling_nip.leading_share",
                                                        "rolling_nip.load", "rolling_nip.indentation",
                                                        "rolling_nip.creep"};

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
  const Solved half_length = x[0], poisson = x[1];
  const Solved beta = (1 - 2 * poisson) / (2 * (1 - poisson));
  const Smooth rest(2 * half_length, smooth_points(2 * x[0], digits), [](const Solved& w) {
    return rounded(kernel_I1(exactly(w)).value() + log(abs(Float(w))));
  });
  const RolledContact contact(
      half_length, [](const Solved&) { return Solved(1); }, [&](const Solved& w) { return rest(w); },
      smooth_points(x[0], digits) + 1);
  const Solved stretched = contact.integral(
      [&](const Solved& at) { return rounded(kernel_I3(exactly(Solved(half_length - at))).value()); });
  const Solved square = half_length * half_length;
  return {contact.load() / (8 * square), contact.indentation() / (8 * square),
          (stretched / pi<Solved>() - beta * contact.load() / 2) / (4 * square),
          contact.middle_pressure() / (4 * half_length), 0};
}

/// Of contacts so long that the rule's points would take for ever, or so long and gripped: nothing is confirmed.
constexpr double longest_confirmed = 4, longest_gripped_confirmed = 0.5;

Numbers elastic_numbers(Arguments x) {
  if (x[0] > (x[2] == 0 ? longest_confirmed : longest_gripped_confirmed)) {
    const Solved unknown = std::numeric_limits<double>::infinity();
    return Numbers(elastic_names.size(), confirmation<Solved>("no rule for so long a contact", 0, unknown));
  }
  if (x[2] == 0) {
    return compared("Kress's rule in Chebyshev's singular weight", without_friction(x, 24),
                    without_friction(x, 19));
  }
  return compared("sinc rule", gripped_numbers(x[0], x[1], true), gripped_numbers(x[0], x[1], false));
}

/// A kernel of the rolling sheet, what it answers at once and what it remembers:
/// I(x) + memory rate int_0^inf e^(-rate w) I(x - w) dw, x downstream.
Solved remembered(Remembered kernel, const Solved& x, const mpq_class& rate, bool coarse) {
  // By v = w - x, where an odd kernel changes its sign.
  const Float sum = history(kernel, -exactly(x), {}, Complex(to_number<Float>(rate)), coarse).real();
  return rounded(kernel == Remembered::I1 ? sum : Float(-sum));
}

/// int_0^inf rate e^(-rate w) sign(x - w) dw
Solved remembered_sign(const Solved& x, const Solved& rate) {
  return x > 0 ? Solved(1 - 2 * exp(-rate * x)) : Solved(-1);
}

std::vector<Solved> rolling(Arguments x, bool coarse) {
  const Solved half_length = x[0];
  // As the material has them: in doubles.
  const double time = x[1] * x[0], theta1 = 1 + x[2], theta2 = theta1 * (1 - 2 * x[2]);
  const double rates[] = {1 / time, (x[4] == 0 ? 1 : 2) / time};
  const double amplitudes[] = {theta1 * (x[3] - 1) / time, theta2 * (x[3] - 1) / time};
  const Solved compliance = Solved(theta1) + Solved(theta2);
  struct Memory {
    mpq_class rate;    ///< of half-thicknesses
    Solved amplitude;  ///< over the rate and the compliance at once
  };
  std::vector<Memory> memories;  // the last one of theta2
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
      sum += memory.amplitude * rate(memory) * remembered(Remembered::I1, w, memory.rate, coarse);
    return sum;
  };
  // Growing exponentials, besides; an even number.
  const double growth = 3 * x[0] * static_cast<double>(rate(memories.back()));
  const int more = (coarse ? 8 : 16) + 2 * static_cast<int>(growth / 2);
  const Smooth rest(2 * half_length, smooth_points(2 * x[0], 11) + more,
                    [&](const Solved& w) { return Solved(normal(w) + share(w) * log(abs(w))); });
  const RolledContact contact(
      half_length, share, [&](const Solved& w) { return rest(w); }, smooth_points(x[0], 11) + more);
  // theta2 * I2 - N * I3, whose smooth part is that without the sign.
  const Solved beta = Solved(theta2) / compliance;
  const auto tangential = [&](const Solved& w) {
    const Solved quarter = pi<Solved>() / 4;
    Solved sum = 2 * quarter * beta * (w > 0 ? 1 : -1) - rounded(kernel_I3(exactly(w)).value());
    for (const Memory& memory : memories) {
      sum -= memory.amplitude * (rate(memory) * remembered(Remembered::I3, w, memory.rate, coarse) +
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

Confirm of_family(std::size_t number, Numbers (*solve)(Arguments)) {
  return [number, solve](Arguments x) {
    static Cache<std::vector<double>, Numbers> kept;
    return (*kept.at({x.begin(), x.end()}, [&] { return solve(x); }))[number];
  };
}

}  // namespace

Confirm of_nip(std::string_view quantity) {
  if (const auto* const found = std::ranges::find(elastic_names, quantity); found != elastic_names.end())
    return of_family(static_cast<std::size_t>(found - elastic_names.begin()), elastic_numbers);
  if (const auto* const found = std::ranges::find(rolling_names, quantity); found != rolling_names.end())
    return of_family(static_cast<std::size_t>(found - rolling_names.begin()), rolling_numbers);
  return {};
}

}  // namespace nipref::verify::confirm
