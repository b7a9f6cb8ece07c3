#pragma once
#include <span>
#include <vector>

#include <nipref/fast/elastic_nip/line_loads.hpp>

namespace nipref::fast {

/// Which kernels a step of the line-load method needs.
struct WantedKernels {
  bool I1 = false;
  bool I3 = false;
  bool I6 = false;
};

/// Their values, empty where not wanted. I6 lacks a function of eta, the same for all alpha: in a symmetric
/// nip it cancels between the loads at +-Y.
struct KernelValues {
  std::vector<double> I1, I3, I6;
};

/// The kernels at each alpha, finite and nonzero, as `method` computes them; counted into `work`.
KernelValues line_load_kernels(const LineLoadMethod& method, std::span<const double> alpha,
                               WantedKernels wanted, Work& work);

}  // namespace nipref::fast
