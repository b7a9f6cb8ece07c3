#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/peers.hpp>

namespace nipref::verify {
namespace {

using fast::Accuracy;
using Columns = Quantity::Columns;
using Values = std::span<double>;

/// A kernel of one argument.
struct KernelRow {
  const char* name;
  const char* argument;
  ref::Enclosure (*by_ref)(const ref::Exact&, int);
  double (*by_fast)(double, Accuracy);
  void (*by_fast_batch)(std::span<const double>, Values, Accuracy);
};

constexpr KernelRow kernels_of_one_argument[] = {
    {"I1", "alpha", ref::I1, fast::I1, fast::I1},
    {"I2", "alpha", ref::I2, [](double alpha, Accuracy) { return fast::I2(alpha); }, nullptr},
    {"I3", "alpha", ref::I3, fast::I3, fast::I3},
    {"I4", "eta", ref::I4, fast::I4, fast::I4},
    {"I5", "eta", ref::I5, fast::I5, fast::I5},
    {"I7", "eta", ref::I7, fast::I7, fast::I7}};

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

}  // namespace

std::vector<Quantity> kernel_entries() {
  std::vector<Quantity> entries{entry_I6()};
  for (const KernelRow& row : kernels_of_one_argument) {
    Quantity entry = entry_of(row.name, {row.argument}, row.by_ref, row.by_fast);
    if (row.by_fast_batch != nullptr) {
      entry.by_fast_batch = [batch = row.by_fast_batch](Columns columns, Values values, Accuracy accuracy) {
        batch(columns[0], values, accuracy);
      };
    }
    if (entry.name == "I1") {
      entry.peers = {{"plain 500-term series", make_plain_series_I1},
                     {"GSL QAWF", make_qawf_I1},
                     {"Boost ooura_fourier_cos", make_ooura_I1}};
      entry.multiprecision_peers = {{"Boost exp_sinh", exp_sinh_I1}};
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace nipref::verify
