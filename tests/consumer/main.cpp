#include <cstdio>
#include <vector>

#include <nipref/data/scene/file.hpp>
#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/kernels.hpp>
#include <nipref/verify/solve/solve.hpp>

int main() {
  using namespace nipref;

  // How wrong is my kernel at 0.73? The reference gives the value with a proven bound.
  const ref::Enclosure truth = ref::I1(ref::Exact::parse("0.73"), 30);
  std::printf("I1(0.73) = %s +- %s\n", truth.value_text().c_str(), truth.error_text().c_str());

  // The same in double, at full accuracy and at six digits, one value or many.
  std::vector<double> alpha{1e-6, 0.73, 20.0};
  std::vector<double> value(alpha.size());
  fast::I1(alpha, value, fast::Accuracy(1e-6));
  std::printf("full %.17g, rtol 1e-6 %.17g\n", fast::I1(0.73), value[1]);

  // A contact from data/scenes/thick-full-friction.toml: what it wants, with estimates of the errors.
  const auto contact = verify::solve(data::load_scene(data::example_scene("thick-full-friction")));
  const fast::Estimate length = contact["contact_length"];
  std::printf("L = %.15g +- %.1e, creep %.15g\n", length.value, length.error, contact["creep_ratio"].value);
}
