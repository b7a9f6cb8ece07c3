#include <nipref/fast/elastic_nip/internal/line_loads_kernels.hpp>
#include <nipref/fast/nip/internal/counted_kernels.hpp>
#include <nipref/fast/sheet/plain_series.hpp>

namespace nipref::fast {
namespace {

KernelValues from_library(Accuracy accuracy, std::span<const double> alpha, WantedKernels wanted,
                          Work& work) {
  CountedKernels kernels(accuracy, work);
  KernelValues values;
  if (wanted.I1) values.I1 = kernels.I1(alpha);
  if (wanted.I3) values.I3 = kernels.I3(alpha);
  if (wanted.I6) values.I6 = kernels.I6(alpha);
  return values;
}

KernelValues from_residues(int terms, std::span<const double> alpha, WantedKernels wanted, Work& work) {
  KernelValues values;
  const auto provide = [&](bool is_wanted, int kernel, std::vector<double>& room) {
    if (!is_wanted) return;
    room.resize(alpha.size());
    work.kernel_evaluations[static_cast<std::size_t>(kernel - 1)] += alpha.size();
    work.terms += alpha.size() * static_cast<std::uint64_t>(terms);
  };
  provide(wanted.I1, 1, values.I1);
  provide(wanted.I3, 3, values.I3);
  provide(wanted.I6, 6, values.I6);
  plain_series(alpha, terms, {values.I1, values.I3, values.I6});
  return values;
}

}  // namespace

KernelValues line_load_kernels(const LineLoadMethod& method, std::span<const double> alpha,
                               WantedKernels wanted, Work& work) {
  return method.residue_terms == 0 ? from_library(method.accuracy, alpha, wanted, work)
                                   : from_residues(method.residue_terms, alpha, wanted, work);
}

}  // namespace nipref::fast
