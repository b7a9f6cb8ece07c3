// The roots of sinh 2z + 2z, the kernels, and the displacements of the elastic sheet's faces.

#include <complex>

#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/fast/sheet/roots.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/ref/sheet/plain_series.hpp>
#include <nipref/ref/sheet/roots.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers.hpp>

namespace nipref::verify {
namespace {

using data::ElasticMaterial;
using fast::Accuracy;
using ref::Exact;
using Columns = Quantity::Columns;
using Values = std::span<double>;

/// The number of a root as an integer; BadInput unless it is one in the catalogue's range.
int whole_number(const Exact& n) {
  const mpq_class& value = n.value();
  if (value.get_den() != 1 || value < 1 || value > 1'000'000)
    throw data::BadInput("n", value.get_str(), "must be a whole number from 1 to 1000000");
  return static_cast<int>(value.get_num().get_si());
}
int whole_number(double n) { return whole_number(Exact(n, "n")); }

Quantity root_entry(const char* name, ref::Enclosure ref::SheetRoot::*of_ref, auto of_fast) {
  return entry_of(
      name, {"n"},
      [of_ref](const Exact& n, int digits) { return ref::sheet_root(whole_number(n), digits).*of_ref; },
      [of_fast](double n) { return of_fast(fast::sheet_root(whole_number(n))); });
}

Quantity residue_entry() {
  const auto coefficients = [](double n, double kernel) {
    return fast::residue_coefficients(static_cast<fast::PlainKernel>(static_cast<int>(kernel)),
                                      whole_number(n));
  };
  return entry_of(
      "residue", {"n", "kernel", "coefficient"},
      [](const Exact& n, const Exact& kernel, const Exact& coefficient, int digits) {
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

/// A kernel of one argument.
Quantity kernel_entry(const char* name, const char* argument, ref::Enclosure (*by_ref)(const Exact&, int),
                      double (*by_fast)(double, Accuracy),
                      void (*by_fast_batch)(std::span<const double>, Values, Accuracy)) {
  Quantity entry = entry_of(name, {argument}, by_ref, by_fast);
  entry.by_fast_batch = [by_fast_batch](Columns columns, Values values, Accuracy accuracy) {
    by_fast_batch(columns[0], values, accuracy);
  };
  return entry;
}

Quantity entry_I1() {
  Quantity entry = kernel_entry("I1", "alpha", ref::I1, fast::I1, fast::I1);
  entry.peers = {{"plain 500-term series", make_plain_series_I1},
                 {"GSL QAWF", make_qawf_I1},
                 {"Boost ooura_fourier_cos", make_ooura_I1}};
  entry.multiprecision_peers = {{"Boost exp_sinh", exp_sinh_I1}};
  return entry;
}

Quantity entry_I6() {
  Quantity entry = entry_of("I6", {"alpha", "eta"}, ref::I6, [](double alpha, double eta, Accuracy accuracy) {
    return fast::I6(alpha, eta, accuracy);
  });
  entry.by_fast_batch = [alpha = argument_number(entry.arguments, "alpha"),
                         eta = argument_number(entry.arguments, "eta")](Columns columns, Values values,
                                                                        Accuracy accuracy) {
    fast::I6(columns[alpha], columns[eta], values, accuracy);
  };
  return entry;
}

auto of_constants(double (*function)(double, const ElasticMaterial&, Accuracy)) {
  return [function](double alpha, double young, double poisson, Accuracy accuracy) {
    return function(alpha, {young, poisson}, accuracy);
  };
}
auto of_constants(double (*function)(double, double, const ElasticMaterial&, Accuracy)) {
  return [function](double alpha, double eta, double young, double poisson, Accuracy accuracy) {
    return function(alpha, eta, {young, poisson}, accuracy);
  };
}

}  // namespace

std::vector<Quantity> kernel_entries() {
  return {root_entry("root.re", &ref::SheetRoot::re, [](std::complex<double> z) { return z.real(); }),
          root_entry("root.im", &ref::SheetRoot::im, [](std::complex<double> z) { return z.imag(); }),
          residue_entry(),
          entry_I1(),
          entry_of("I2", {"alpha"}, ref::I2, [](double alpha) { return fast::I2(alpha); }),
          kernel_entry("I3", "alpha", ref::I3, fast::I3, fast::I3),
          kernel_entry("I4", "eta", ref::I4, fast::I4, fast::I4),
          kernel_entry("I5", "eta", ref::I5, fast::I5, fast::I5),
          entry_I6(),
          kernel_entry("I7", "eta", ref::I7, fast::I7, fast::I7),
          entry_of("F1", {"eta", "poisson"}, ref::F1, fast::F1),
          entry_of("F2", {"eta", "poisson"}, ref::F2, fast::F2),
          entry_of("un", {"alpha", "young", "poisson"}, ref::un, of_constants(fast::un)),
          entry_of("us", {"alpha", "young", "poisson"}, ref::us, of_constants(fast::us)),
          entry_of("vn", {"alpha", "eta", "young", "poisson"}, ref::vn, of_constants(fast::vn)),
          entry_of("vs", {"alpha", "eta", "young", "poisson"}, ref::vs, of_constants(fast::vs))};
}

}  // namespace nipref::verify
