#include <complex>

#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/ref/sheet/plain_series.hpp>
#include <nipref/ref/sheet/roots.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

constexpr long largest_index = 1'000'000;

/// The number of a root as an integer; BadInput unless it is one in the catalogue's range.
int whole_number(const ref::Exact& n) {
  const mpq_class& value = n.value();
  if (value.get_den() != 1 || value < 1 || value > largest_index)
    throw data::BadInput("n", value.get_str(), "must be a whole number from 1 to 1000000");
  return static_cast<int>(value.get_num().get_si());
}

std::complex<double> fast_root(double n) { return fast::sheet_root(whole_number(ref::Exact(n, "n"))); }

Quantity residue_entry() {
  const auto coefficients = [](double n, double kernel) {
    return fast::residue_coefficients(static_cast<fast::PlainKernel>(static_cast<int>(kernel)),
                                      whole_number(ref::Exact(n, "n")));
  };
  return entry_of(
      "residue", {"n", "kernel", "coefficient"},
      [](const ref::Exact& n, const ref::Exact& kernel, const ref::Exact& coefficient, int digits) {
        const auto which = static_cast<ref::PlainKernel>(static_cast<int>(kernel.approximate()));
        const ref::ResidueCoefficients both = ref::residue_coefficients(which, whole_number(n), digits);
        return coefficient.sign() == 0 ? both.A : both.B;
      },
      [coefficients](double n, double kernel, double coefficient) {
        const fast::ResidueCoefficients both = coefficients(n, kernel);
        return coefficient == 0 ? both.A : both.B;
      },
      [coefficients](double n, double kernel, double /*coefficient*/) {
        const fast::ResidueCoefficients both = coefficients(n, kernel);
        return std::hypot(both.A, both.B);
      });
}

}  // namespace

std::vector<Quantity> root_entries() {
  const auto root = [](const ref::Exact& n, int digits) { return ref::sheet_root(whole_number(n), digits); };
  return {entry_of(
              "root.re", {"n"}, [root](const ref::Exact& n, int digits) { return root(n, digits).re; },
              [](double n) { return fast_root(n).real(); }),
          entry_of(
              "root.im", {"n"}, [root](const ref::Exact& n, int digits) { return root(n, digits).im; },
              [](double n) { return fast_root(n).imag(); }),
          residue_entry()};
}

}  // namespace nipref::verify
