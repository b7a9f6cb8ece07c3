#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/confirm/contacts.hpp>
#include <nipref/verify/golden/confirm/kernels.hpp>
#include <nipref/verify/support/internal/cache.hpp>

namespace nipref::verify::confirm {
namespace {

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
Float remembered(const Remembered& kernel, const Float& x, const Float& rate, bool coarse) {
  // The integration variable is v = w - x, so that an odd kernel changes its sign.
  const Float sum = history(kernel, -exactly(x), {}, Complex(rate), coarse).real();
  return kernel.is_odd ? Float(-sum) : sum;
}

/// int_0^inf rate e^(-rate w) sign(x - w) dw
Float remembered_sign(const Float& x, const Float& rate) {
  return x > 0 ? Float(1 - 2 * exp(-rate * x)) : Float(-1);
}

/// What rolling_numbers() returns; a sheet without memory is an elastic one.
std::vector<Float> rolling(const RollingSheet& sheet, bool coarse) {
  const Float& half_length = sheet.half_length;
  const auto share = [&](const Float& w) {
    Float sum = 1;
    for (const auto& memory : sheet.memories) sum -= memory.of_normal * expm1(-memory.rate * w);
    return sum;
  };
  const auto normal = [&](const Float& w) {
    Float sum = kernel_I1(exactly(w)).value();
    for (const auto& memory : sheet.memories)
      sum += memory.of_normal * memory.rate * remembered(remembered_I1, w, memory.rate, coarse);
    return sum;
  };
  // A memory needs more points, an even number, for the growing exponentials.
  const double reach = half_length.convert_to<double>(), elastic_digits = coarse ? 19 : 24,
               digits = sheet.memories.empty() ? elastic_digits : 11;
  int more = 0;
  for (const auto& memory : sheet.memories)
    more = std::max(
        more, (coarse ? 8 : 16) + 2 * static_cast<int>(3 * reach * memory.rate.convert_to<double>() / 2));
  const Interpolant rest(-2 * half_length, 2 * half_length, smooth_points(2 * reach, digits) + more,
                         [&](const Float& w) { return Float(normal(w) + share(w) * log(abs(w))); });
  const RolledContact contact(
      half_length, share, [&](const Float& w) { return rest(w); }, smooth_points(reach, digits) + more);
  // The kernel theta2 * I2 - N * I3.
  const auto tangential = [&](const Float& w) {
    const Float quarter = pi() / 4;
    Float sum = 2 * quarter * sheet.theta2 * (w > 0 ? 1 : -1) - kernel_I3(exactly(w)).value();
    for (const auto& memory : sheet.memories) {
      const Float &rate = memory.rate, step = quarter * remembered_sign(w, rate);
      sum -= memory.of_normal * (rate * remembered(remembered_I3, w, rate, coarse) + step);
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
    return compared("sinc rule", gripped_numbers(x["L_over_B"], x["poisson"], true),
                    gripped_numbers(x["L_over_B"], x["poisson"], false));
  const Float poisson = x["poisson"];
  const Numbers all = rolling_numbers({x["L_over_B"], (1 - 2 * poisson) / (2 - 2 * poisson), {}});
  return {all[2], all[3], all[4], all[5], confirmation(all[5].method, Float(0), Float(0))};
}

/// The sheet of rolling_nip.*, whose constants are doubles.
RollingSheet rolling_sheet(Arguments x) {
  const double time = x["memory_over_L"] * x["L_over_B"], theta1 = 1 + x["poisson"],
               theta2 = theta1 * (1 - 2 * x["poisson"]), more_soft = x["softening"] - 1;
  const Float compliance = Float(theta1) + theta2;
  RollingSheet sheet{x["L_over_B"], theta2 / compliance, {}};
  const auto remember = [&](double at_once, double rate, bool is_theta2) {
    const Float amplitude = at_once * more_soft / time / Float(rate) / compliance;
    sheet.remember({Float(rate) / 2, amplitude, is_theta2 ? amplitude : Float(0)});
  };
  remember(theta1, 1 / time, false);
  remember(theta2, (x["material"] == 0 ? 1 : 2) / time, true);
  return sheet;
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
