#include <complex>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/ref/sheet/roots.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

constexpr long largest_index = 1'000'000;

/// The number of a root as an integer; BadInput unless it is one in the catalogue's range.
long whole_number(const ref::Exact& n) {
  const mpq_class& value = n.value();
  if (value.get_den() != 1 || value < 1 || value > largest_index) {
    throw data::BadInput("n", value.get_str(), "must be a whole number from 1 to 1000000");
  }
  return value.get_num().get_si();
}

std::complex<double> fast_root(double n) {
  return fast::sheet_root(static_cast<int>(whole_number(ref::Exact(n, "n"))));
}

}  // namespace

std::vector<Quantity> root_entries() {
  const auto root = [](const ref::Exact& n, int digits) { return ref::sheet_root(whole_number(n), digits); };
  return {entry_of(
              "root.re", {"n"}, [root](const ref::Exact& n, int digits) { return root(n, digits).re; },
              [](double n) { return fast_root(n).real(); }),
          entry_of(
              "root.im", {"n"}, [root](const ref::Exact& n, int digits) { return root(n, digits).im; },
              [](double n) { return fast_root(n).imag(); })};
}

}  // namespace nipref::verify
