#include <nipref/ref/half_space/internal/contact.hpp>
#include <nipref/ref/half_space/rolling_sphere.hpp>

namespace nipref::ref {
namespace {

/// K K_nn - S^2 vanishes at the critical speed.
constexpr int cancelled_digits = 32;

}  // namespace

Estimated rolling_index(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return with_digits(
      digits,
      [&](int working) {
        const WorkingAnswer line = WorkingSurface(surface, working).at(degrees);
        const Float q = line.coupling / sqrt(line.compliance * line.in_line);
        return closed(atanh(q) / pi(), digits);
      },
      cancelled_digits);
}

Estimated rolling_span_ratio(const SurfaceAnswer& surface, const Exact& degrees, int digits) {
  return with_digits(
      digits,
      [&](int working) {
        const WorkingSurface lines(surface, working);
        const auto squared_amplitude = [&](const Exact& at) -> Float {
          const WorkingAnswer line = lines.at(at);
          return line.in_line / line.compliance /
                 (line.compliance * line.in_line - line.coupling * line.coupling);
        };
        return closed(sqrt(squared_amplitude(Exact(0.0)) / squared_amplitude(degrees)), digits);
      },
      cancelled_digits);
}

}  // namespace nipref::ref
