#include <nipref/ref/sheet/internal/field_integral.hpp>

namespace nipref::ref {

Interval field_integral(const FieldIntegrand& integrand, const FieldPoint& at, double nats) {
  return at.alpha.value() >= 1 ? field_by_residues(integrand, at, nats)
                               : field_by_summation(integrand, at, nats);
}

}  // namespace nipref::ref
