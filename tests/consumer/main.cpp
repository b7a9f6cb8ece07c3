#include <cstdio>
#include <vector>

#include "fast/contact_line_loads.hpp"
#include "fast/sheet_kernels.hpp"
#include "ref/sheet_kernels.hpp"

int main() {
  using namespace nipref;

  // How wrong is my kernel at 0.73? The reference gives the value with a proven bound.
  const ref::Enclosure truth = ref::I1(ref::Exact::parse("0.73"), 30);
  std::printf("I1(0.73) = %s +- %s\n", truth.value_text().c_str(), truth.bound_text().c_str());

  // The same in double, at full accuracy and at six digits, one value or many.
  std::vector<double> alpha{1e-6, 0.73, 20.0};
  std::vector<double> value(alpha.size());
  fast::I1(alpha, value, fast::Accuracy(1e-6));
  std::printf("full %.17g, rtol 1e-6 %.17g\n", fast::I1(0.73), value[1]);

  // A frictionless nip: roller radius 6 in, sheet 1 in thick, 100 lbf/in, two line loads a side.
  const data::ElasticNip nip{6.0, 1.0, {1.45e5, 1.0 / 3}};
  const fast::LineLoadSolution contact = fast::line_loads_for_load(nip, 2, 100.0);
  std::printf("contact length %.6g in, peak pressure %.6g psi\n", contact.contact_length,
              contact.peak_pressure);
}
