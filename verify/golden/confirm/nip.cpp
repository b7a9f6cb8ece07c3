#include <limits>
#include <vector>

#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/contacts.hpp>
#include <nipref/verify/golden/confirm/history.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify::confirm {
namespace {

using Numbers = std::vector<Confirmation>;

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
      [](const Solved& w) { return Solved(kernel_I1(exactly(w)).value() + log(abs(Float(w)))); });
  const RolledContact contact(
      half_length, [](const Solved&) { return Solved(1); }, [&](const Solved& w) { return rest(w); },
      smooth_points(x["L_over_B"], digits) + 1);
  const Solved stretched = contact.integral(
      [&](const Solved& at) { return Solved(kernel_I3(exactly(Solved(half_length - at))).value()); });
  const Solved square = half_length * half_length;
  return {contact.load() / (8 * square), contact.indentation() / (8 * square),
          (stretched / pi<Solved>() - beta * contact.load() / 2) / (4 * square),
          contact.middle_pressure() / (4 * half_length), 0};
}

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
  return Solved(kernel.is_odd ? Float(-sum) : sum);
}

/// int_0^inf rate e^(-rate w) sign(x - w) dw
Solved remembered_sign(const Solved& x, const Solved& rate) {
  return x > 0 ? Solved(1 - 2 * exp(-rate * x)) : Solved(-1);
}

std::vector<Solved> rolling(const RollingSheet& sheet, bool coarse) {
  const auto number = [](const mpq_class& x) { return to_number<Solved>(x); };
  const Solved half_length = number(sheet.half_length);
  const auto share = [&](const Solved& w) {
    Solved sum = 1;
    for (const auto& memory : sheet.memories)
      sum -= number(memory.of_normal) * expm1(Solved(-number(memory.rate) * w));
    return sum;
  };
  const auto normal = [&](const Solved& w) {
    Solved sum = Solved(kernel_I1(exactly(w)).value());
    for (const auto& memory : sheet.memories)
      sum += number(memory.of_normal * memory.rate) * remembered(remembered_I1, w, memory.rate, coarse);
    return sum;
  };
  // More points, an even number, for the growing exponentials.
  const double reach = sheet.half_length.get_d(),
               fastest =
                   std::ranges::max(sheet.memories, {}, [](auto&m) { return m.rate.get_d(); }).rate.get_d();
  const int more = (coarse ? 8 : 16) + 2 * static_cast<int>(3 * reach * fastest / 2);
  const Smooth rest(-2 * half_length, 2 * half_length, smooth_points(2 * reach, 11) + more,
                    [&](const Solved& w) { return Solved(normal(w) + share(w) * log(abs(w))); });
  const RolledContact contact(
      half_length, share, [&](const Solved& w) { return rest(w); }, smooth_points(reach, 11) + more);
  // The kernel theta2 * I2 - N * I3.
  const auto tangential = [&](const Solved& w) {
    const Solved quarter = pi<Solved>() / 4;
    Solved sum =
        2 * quarter * number(sheet.theta2) * (w > 0 ? 1 : -1) - Solved(kernel_I3(exactly(w)).value());
    for (const auto& memory : sheet.memories) {
      const Solved rate = number(memory.rate), step = quarter * remembered_sign(w, rate);
      sum -= number(memory.of_normal) * (rate * remembered(remembered_I3, w, memory.rate, coarse) + step);
      sum += 2 * number(memory.of_theta2) * step;
    }
    return sum;
  };
  const Solved stretched = contact.integral(
      [&](const Solved& at) { return Solved(tangential(at - half_length) - tangential(at + half_length)); });
  const Solved square = half_length * half_length;
  return {(contact.offset() + contact.moment() / contact.load()) / (2 * half_length),
          (contact.offset() + half_length) / (2 * half_length), contact.load() / (8 * square),
          contact.indentation() / (8 * square), stretched / pi<Solved>() / (8 * square)};
}

}  // namespace

Numbers rolling_numbers(const RollingSheet& sheet) {
  return compared("Kress's rule in Chebyshev's singular weight", rolling(sheet, false), rolling(sheet, true));
}

namespace {

/// The sheet of rolling_nip.*, whose constants are doubles.
RollingSheet rolling_sheet(Arguments x) {
  const double time = x["memory_over_L"] * x["L_over_B"], theta1 = 1 + x["poisson"],
               theta2 = theta1 * (1 - 2 * x["poisson"]), more_soft = x["softening"] - 1;
  const mpq_class compliance = mpq_class(theta1) + mpq_class(theta2);
  RollingSheet sheet{x["L_over_B"], mpq_class(theta2) / compliance, {}};
  const auto remember = [&](double at_once, double rate, bool is_theta2) {
    const mpq_class amplitude = mpq_class(at_once * more_soft / time) / rate / compliance;
    sheet.remember({mpq_class(rate) / 2, amplitude, is_theta2 ? amplitude : mpq_class(0)});
  };
  remember(theta1, 1 / time, false);
  remember(theta2, (x["material"] == 0 ? 1 : 2) / time, true);
  return sheet;
}

Numbers rolling_nip_numbers(Arguments x) { return rolling_numbers(rolling_sheet(x)); }

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
    add_family(all, "rolling_nip", rolling_nip_numbers);
    return all;
  }();
  return methods;
}

}  // namespace nipref::verify::confirm
