#include <cmath>

#include <nipref/data/bad_input.hpp>
#include <nipref/ref/nip/internal/inner_field.hpp>
#include <nipref/ref/nip/line_load_field.hpp>
#include <nipref/ref/number/enclosure.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/ref/sheet/internal/intervals.hpp>

namespace nipref::ref {
namespace {

using data::SheetLoad;

constexpr int load_guard = 6;  ///< extra digits of the single loads' fields

/// The sums over the loads of one kernel at a point.
struct LoadSums {
  std::span<const FaceLoad> loads;
  mpq_class half_thickness;
  InnerPoint point;
  int digits;

  /// The sum over the loads of force times kernel(alpha, kind) times `unit`, alpha the distance from the load. If its
  /// place errs by e, the kernel errs by at most its change over e on one side plus e^2 times a bound of its curvature.
  [[nodiscard]] Estimate operator()(const Exact& unit, const auto& kernel) const {
    const mpfr_prec_t bits = working_bits();
    Interval sum(bits);
    bool is_proven = true;
    for (const FaceLoad& load : loads) {
      for (const SheetLoad kind : {SheetLoad::normal, SheetLoad::shear}) {
        const Estimate& force = kind == SheetLoad::normal ? load.normal : load.shear;
        if (force.value == 0 && force.error == 0) continue;
        Interval here = interval_of(kernel(distance(load.y.value), kind));
        if (load.y.error > 0) {
          const Estimate moved = kernel(distance(at_working_precision(load.y.value) + load.y.error), kind);
          const Interval error(Exact(to_exact(load.y.error).value() / half_thickness), bits);
          here = here.widened(magnitude_of(interval_of(moved) - here) + square(error) * curvature());
        }
        sum = sum + interval_of(force) * here;
        is_proven = is_proven && force.proven && load.y.proven && std::fabs(point.depth) < 1;
      }
    }
    Estimate result = enclosure_of(Interval(unit, bits) * sum, digits);
    result.proven = is_proven;
    return result;
  }

 private:
  [[nodiscard]] Exact distance(const Float& y) const {
    const Exact from_load((Exact(point.y).value() - to_exact(y).value()) / half_thickness);
    if (from_load.sign() == 0 && std::fabs(point.depth) == 1)
      throw data::BadInput("field.positions", point.y, "must not be the place of a line load on a face");
    return from_load;
  }
  /// A bound of the kernels' curvature as functions of alpha: ref/sheet/README.md, Inside the sheet. On the faces none
  /// is known: there this returns 0, and nothing is proven.
  [[nodiscard]] Interval curvature() const {
    const mpq_class depth = 1 - abs(Exact(point.depth).value());
    return depth == 0 ? Interval(working_bits()) : 160 / square(square(Interval(depth, working_bits())));
  }
};

/// Returns result(sums, point) at each point.
template <class Result>
std::vector<Result> at_each(std::span<const FaceLoad> loads, double half_thickness,
                            std::span<const InnerPoint> points, int digits, const auto& result) {
  const WorkingDigits working(digits + 2 * load_guard);
  std::vector<Result> results;
  for (const InnerPoint& point : points) {
    checked_point(point, half_thickness);
    results.push_back(result(LoadSums{loads, Exact(half_thickness).value(), point, digits}, point));
  }
  return results;
}

}  // namespace

std::vector<InnerStresses> line_load_stresses(std::span<const FaceLoad> loads, double half_thickness,
                                              std::span<const InnerPoint> points, int digits) {
  const Exact unit(1 / Exact(half_thickness).value());
  const auto stresses = [&](const LoadSums& sum, const InnerPoint& point) -> InnerStresses {
    const Exact depth(point.depth);
    const auto of = [&](const auto& kernel) {
      return sum(unit, [&](const Exact& alpha, SheetLoad kind) {
        return kernel(alpha, depth, kind, digits + load_guard);
      });
    };
    return {of(sheet_across), of(sheet_along), of(sheet_shear)};
  };
  return at_each<InnerStresses>(loads, half_thickness, points, digits, stresses);
}

std::vector<InnerDisplacements> line_load_displacements(std::span<const FaceLoad> loads,
                                                        double half_thickness,
                                                        const data::ElasticMaterial& material,
                                                        std::span<const InnerPoint> points, int digits) {
  const Exact poisson(material.poisson), compliance(normal_compliance(Exact(material.young), poisson));
  const Exact inwards(-compliance.value()), middle(0.0);
  const auto displacements = [&](const LoadSums& sum, const InnerPoint& point) -> InnerDisplacements {
    const Exact depth(std::fabs(point.depth));
    const auto u = [&](const Exact& alpha, SheetLoad kind) {
      return sheet_u(alpha, depth, kind, poisson, digits + load_guard);
    };
    // v of a single load is relative to a point at that load. These constants cancel between symmetric loads.
    const auto v = [&](const Exact& alpha, SheetLoad kind) {
      return sheet_v(alpha, middle, depth, kind, poisson, digits + load_guard);
    };
    return {sum(inwards, u), point.y == 0 ? Estimate(exact_zero(digits)) : sum(compliance, v)};
  };
  return at_each<InnerDisplacements>(loads, half_thickness, points, digits, displacements);
}

}  // namespace nipref::ref
