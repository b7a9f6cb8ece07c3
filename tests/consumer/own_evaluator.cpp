#include <cstdio>

#include <nipref/fast/sheet/plain_series.hpp>
#include <nipref/verify/audit/audit.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>

// How wrong is my own kernel, and where? An entry of the catalogue with my evaluator in place of fast's is audited as
// fast's are: at hard cases, dense and random arguments, then around the worst.
int main() {
  using namespace nipref;

  verify::Quantity mine = verify::find_quantity("I1");
  mine.by_fast = [](std::span<const double> arguments, fast::Accuracy) {
    return fast::plain_series_I1(arguments[0], 20);  // any code of one's own
  };
  verify::AuditOptions options;
  options.points = 1000;
  const verify::AuditResult found = verify::audit(mine, options);
  std::printf("up to %.1e units in the last place wrong, at alpha = %.6g: promise of %g %s\n",
              found.max_error_ulp, found.worst[0], mine.promise, found.kept() ? "kept" : "missed");
}
