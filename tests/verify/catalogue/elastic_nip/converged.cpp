#include <nipref/ref/nip/internal/nip_solution.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/test.hpp"

using namespace nipref;
using verify::Point;

namespace {

double nip(const char* number, const Point& point) {
  return verify::find_quantity(number).by_fast(point, {});
}

ref::Estimate nip_reference(const char* number, const Point& point) {
  return verify::ref_value(verify::find_quantity(number), point, 18);
}

}  // namespace

TEST_CASE("dimensionless nips: what is proven says so, and fast's errors are covered to both ends") {
  CHECK(nip_reference("nip.load", {0.5, 0.3, 0}).proven);
  CHECK(nip_reference("nip.load", {0.5, 0.3, 1}).proven);
  CHECK_FALSE(nip_reference("nip.load", {5, 0.3, 1}).proven);
  CHECK(nip_reference("nip.peak_pressure", {0.5, 0.3, 1}).proven);
  CHECK(nip_reference("nip.peak_shear", {0.5, 0.3, 1}).proven);
  for (const char* name :
       {"nip.load", "nip.indentation", "nip.creep", "nip.peak_pressure", "nip.peak_shear"}) {
    const verify::Quantity& quantity = verify::find_quantity(name);
    for (const Point& point : {Point{1e-6, 0.5, 1}, Point{1e-6, 0, 0}, Point{1, 0.4999, 1}}) {
      CAPTURE(name, point[0]);
      CHECK(std::fabs(nip_reference(name, point).error_of(nip(name, point))) <=
            quantity.fast_error(point, {}));
    }
  }
}

TEST_CASE("dimensionless nips: all numbers of a gripped contact by panels come out of one solution") {
  const long before = ref::NipSolution::solved();
  for (const char* name : {"nip.load", "nip.indentation", "nip.creep", "nip.peak_pressure", "nip.peak_shear"})
    static_cast<void>(nip_reference(name, {5, 0.25, 1}));
  CHECK(ref::NipSolution::solved() - before == 2);  // the second one is for the error
}

TEST_CASE("an audit finds an error that is larger than fast says it is, though it keeps the promise") {
  verify::Quantity modest = verify::find_quantity("nip.load");
  verify::AuditOptions options;
  options.points = 3;
  CHECK(verify::audit(modest, options).kept());
  modest.fast_error = [](std::span<const double>, fast::Accuracy) { return 1e-18; };
  CHECK_FALSE(verify::audit(modest, options).kept());
  // Another evaluator only has to keep the promise.
  CHECK(verify::audit(modest, verify::fast_evaluator(modest, {}), options).kept());
}
