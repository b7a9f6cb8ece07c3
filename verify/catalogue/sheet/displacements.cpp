#include <nipref/fast/sheet/kernels.hpp>
#include <nipref/ref/sheet/displacements.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::ElasticMaterial;
using fast::Accuracy;

using Function = double (*)(double, const ElasticMaterial&, Accuracy);
using FunctionOfTwo = double (*)(double, double, const ElasticMaterial&, Accuracy);

auto of_constants(Function function) {
  return [function](double alpha, double young, double poisson, Accuracy accuracy) {
    return function(alpha, {young, poisson}, accuracy);
  };
}
auto of_constants(FunctionOfTwo function) {
  return [function](double alpha, double eta, double young, double poisson, Accuracy accuracy) {
    return function(alpha, eta, {young, poisson}, accuracy);
  };
}

}  // namespace

std::vector<Quantity> displacement_entries() {
  return {entry_of("F1", {"eta", "poisson"}, ref::F1, fast::F1),
          entry_of("F2", {"eta", "poisson"}, ref::F2, fast::F2),
          entry_of("un", {"alpha", "young", "poisson"}, ref::un, of_constants(fast::un)),
          entry_of("us", {"alpha", "young", "poisson"}, ref::us, of_constants(fast::us)),
          entry_of("vn", {"alpha", "eta", "young", "poisson"}, ref::vn, of_constants(fast::vn)),
          entry_of("vs", {"alpha", "eta", "young", "poisson"}, ref::vs, of_constants(fast::vs))};
}

}  // namespace nipref::verify
