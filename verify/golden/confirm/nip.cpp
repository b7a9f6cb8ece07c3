#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <nipref/verify/catalogue/internal/kept.hpp>
#include <nipref/verify/golden/confirm/gripped_contact.hpp>
#include <nipref/verify/golden/confirm/history.hpp>
#include <nipref/verify/golden/confirm/nip.hpp>
#include <nipref/verify/golden/confirm/rolled_contact.hpp>

namespace nipref::verify::confirm {
namespace {

using Arguments = std::span<const double>;
/// All numbers of a contact, in the order of their names.
using Numbers = std::vector<Witness>;

constexpr std::array<std::string_view, 5> elastic_names{"nip.load", "nip.indentation", "nip.creep",
                                                        "nip.peak_pressure", "nip.peak_shear"};
Solved rounded(const Float& x) { return Solved(x); }

mpq_class exactly(const Solved& x) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), x.backend().data());
  return value;
}

std::vector<Witness> compared(const char* method, const std::vector<Solved>& fine,
                              const std::vector<Solved>& coarse) {
  std::vector<Witness> result;
  for (std::size_t i = 0; i < fine.size(); ++i)
    result.push_back(witness<Solved>(method, fine[i], fine[i] - coarse[i]));
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

Numbers elastic_numbers(Arguments x) {
  if (x[2] == 0) {
    return compared("Kress's rule in Chebyshev's singular weight", without_friction(x, 30),
                    without_friction(x, 24));
  }
  return compared("sinc rule", gripped_numbers(x[0], x[1], true), gripped_numbers(x[0], x[1], false));
}

Confirm of_family(std::size_t number, Numbers (*solve)(Arguments)) {
  return [number, solve](Arguments x) {
    static Kept<std::vector<double>, Numbers> kept;
    return (*kept.at({x.begin(), x.end()}, [&] { return solve(x); }))[number];
  };
}

}  // namespace

Confirm of_nip(std::string_view quantity) {
  if (const auto* const found = std::ranges::find(elastic_names, quantity); found != elastic_names.end())
    return of_family(static_cast<std::size_t>(found - elastic_names.begin()), elastic_numbers);
  return {};
}

}  // namespace nipref::verify::confirm
