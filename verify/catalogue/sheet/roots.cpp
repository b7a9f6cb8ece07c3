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

long whole_number(double n) { return whole_number(ref::Exact(n, "n")); }

Argument index_argument() {
  return {"n", ArgumentKind::index, std::nullopt, {1, 2, 3, 10, 499, 500, 501, 999'999, 1'000'000}};
}

std::complex<double> fast_root(std::span<const double> arguments) {
  return fast::sheet_root(static_cast<int>(whole_number(arguments[0])));
}

Quantity real_part() {
  Quantity entry;
  entry.name = "root.re";
  entry.definition = "real part of the n-th root of sinh 2z + 2z = 0 in the first quadrant";
  entry.source = "thesis, appendix IV";
  entry.scale = "the value";
  entry.arguments = {index_argument()};
  entry.promise = 2;
  entry.by_ref = [](auto arguments, int digits) {
    return ref::sheet_root(whole_number(arguments[0]), digits).re;
  };
  set_fast(entry, [](auto arguments, fast::Accuracy) { return fast_root(arguments).real(); });
  entry.envelope = [](auto) { return 0.0; };
  return entry;
}

Quantity imaginary_part() {
  Quantity entry = real_part();
  entry.name = "root.im";
  entry.definition = "imaginary part of the n-th root of sinh 2z + 2z = 0 in the first quadrant";
  entry.by_ref = [](auto arguments, int digits) {
    return ref::sheet_root(whole_number(arguments[0]), digits).im;
  };
  set_fast(entry, [](auto arguments, fast::Accuracy) { return fast_root(arguments).imag(); });
  return entry;
}

}  // namespace

std::vector<Quantity> root_entries() { return {real_part(), imaginary_part()}; }

}  // namespace nipref::verify
