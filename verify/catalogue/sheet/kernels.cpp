#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers_double.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers_multiprecision.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using Arguments = std::span<const double>;
using Exacts = std::span<const ref::Exact>;
using Columns = Quantity::Columns;
using Values = std::span<double>;

constexpr double kernel_promise = 2;

/// The evaluators of a kernel of one argument; the overloads are picked by these types.
struct OneArgument {
  ref::Enclosure (*by_ref)(const ref::Exact&, int);
  double (*by_fast)(double, Accuracy);
  void (*by_fast_batch)(std::span<const double>, std::span<double>, Accuracy);
};

Quantity entry_of(std::string name, std::string definition, std::string source, Argument argument,
                  const OneArgument& evaluators) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = std::move(source);
  entry.scale = "the value";
  entry.arguments = {std::move(argument)};
  entry.promise = kernel_promise;
  entry.by_ref = [evaluators](Exacts a, int digits) { return evaluators.by_ref(a[0], digits); };
  set_fast(entry,
           [evaluators](Arguments a, Accuracy accuracy) { return evaluators.by_fast(a[0], accuracy); });
  entry.by_fast_batch = [evaluators](Columns a, Values values, Accuracy accuracy) {
    evaluators.by_fast_batch(a[0], values, accuracy);
  };
  entry.envelope = [](Arguments) { return 0.0; };
  return entry;
}

/// Kernels that oscillate about 0 are measured against the amplitude of the oscillation.
void measure_against(Quantity& entry, double (*envelope)(double)) {
  entry.scale = "max(|value|, amplitude of the slowest residue term)";
  entry.envelope = [envelope](Arguments a) { return envelope(a[0]); };
}

Quantity entry_I1() {
  Quantity entry = entry_of("I1", "int_0^inf 2 sinh^2 x cos(alpha x) / (x (sinh 2x + 2x)) dx",
                            "thesis (4.9), (AI.1), (AI.9)", nonzero_position_argument("alpha"),
                            {ref::I1, fast::I1, fast::I1});
  measure_against(entry, envelope_I1);
  entry.peers = {{"plain 500-term series", make_plain_series_I1},
                 {"GSL QAWF", make_qawf_I1},
                 {"Boost ooura_fourier_cos", make_ooura_I1}};
  entry.multiprecision_peers = {{"Boost exp_sinh", exp_sinh_I1}};
  return entry;
}

Quantity entry_I2() {
  Quantity entry = entry_of("I2", "int_0^inf sin(alpha x) / x dx = pi/2 sign(alpha)", "thesis (4.9), (AI.10)",
                            position_argument("alpha"),
                            {ref::I2, [](double alpha, Accuracy) { return fast::I2(alpha); }, nullptr});
  entry.by_fast_batch = nullptr;
  return entry;
}

Quantity entry_I3() {
  return entry_of("I3", "int_0^inf 2 sin(alpha x) / (sinh 2x + 2x) dx", "thesis (4.9), (AI.12)",
                  position_argument("alpha"), {ref::I3, fast::I3, fast::I3});
}

Quantity entry_I4() {
  return entry_of("I4", "int_0^inf 2 sinh x sin(eta x) / (x (sinh 2x + 2x)) dx", "thesis (4.9), (AI.12)",
                  position_argument("eta"), {ref::I4, fast::I4, fast::I4});
}

Quantity entry_I5() {
  return entry_of("I5", "int_0^inf 2 cosh x sin(eta x) / (sinh 2x + 2x) dx", "thesis (4.9), (AI.12)",
                  position_argument("eta"), {ref::I5, fast::I5, fast::I5});
}

Quantity entry_I6() {
  Quantity entry;
  entry.name = "I6";
  entry.definition = "int_0^inf 2 cosh x (cosh x cos(alpha x) - cos(eta x)) / (x (sinh 2x + 2x)) dx";
  entry.source = "thesis (4.20), (AI.12)";
  entry.scale = "max(|I6|, sum of the slowest residue terms' amplitudes of the alpha and the eta part)";
  entry.arguments = {nonzero_position_argument("alpha"), position_argument("eta")};
  entry.promise = kernel_promise;
  entry.by_ref = [](Exacts a, int digits) { return ref::I6(a[0], a[1], digits); };
  set_fast(entry, [](Arguments a, Accuracy accuracy) { return fast::I6(a[0], a[1], accuracy); });
  entry.by_fast_batch = [](Columns a, Values values, Accuracy accuracy) {
    fast::I6(a[0], a[1], values, accuracy);
  };
  entry.envelope = [](Arguments a) { return envelope_r(a[0]) + envelope_s(a[1]); };
  return entry;
}

Quantity entry_I7() {
  Quantity entry =
      entry_of("I7", "int_0^inf 2 sinh x cos(eta x) / (sinh 2x + 2x) dx", "thesis (4.20), (AI.12)",
               position_argument("eta"), {ref::I7, fast::I7, fast::I7});
  measure_against(entry, envelope_I7);
  return entry;
}

}  // namespace

std::vector<Quantity> kernel_entries() {
  return {entry_I1(), entry_I2(), entry_I3(), entry_I4(), entry_I5(), entry_I6(), entry_I7()};
}

}  // namespace nipref::verify
