// The field inside the sheet under one line load on each face.

#include <nipref/fast/sheet/field.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/envelopes.hpp>

namespace nipref::verify {
namespace {

using data::Derivative;
using data::SheetLoad;
using ref::Exact;

constexpr double nearest_on_the_face = 1e-300;

SheetLoad load_of(double number) { return number == 0 ? SheetLoad::normal : SheetLoad::shear; }
SheetLoad load_of(const ref::Exact& number) { return load_of(number.approximate()); }

/// Places where fast changes from closed forms to residues, and where the residues underflow.
constexpr std::array hard_alphas{0.0,  1e-300, 1e-16, 1e-8,  0.5,   0x1.3ffffffffffffp+0,
                                 1.25, 12.2,   100.0, 336.0, 354.0, 700.0};
constexpr std::array hard_depths{1.0, 1 - 0x1p-53, 0.9, 0.5, 0.5 - 0x1p-54, 1e-16, 1e-300, 0.0};

struct InnerPoint {
  double alpha, depth;
};

/// Draws places on lines towards the load, on and just below the face, near the middle plane, far away, and hard places.
InnerPoint draw_anywhere(Random& random) {
  const double side = random.chance(0.5) ? 1 : -1, face = random.chance(0.5) ? 1 : -1;
  const std::size_t way = random.index(7);
  if (way < 2) {
    const double distance = random.log_uniform(nearest_on_the_face * 2, 1);
    const double angle = random.uniform(0, std::numbers::pi / 2);
    return {side * distance * std::cos(angle), face * (1 - distance * std::sin(angle))};
  }
  if (way == 2)
    return {side * random.log_uniform(1e-20, 10),
            face * (1 - std::ldexp(static_cast<double>(random.index(4)), -53))};
  if (way == 3)
    return {side * random.log_uniform(1e-20, 10), face * random.log_uniform(nearest_on_the_face, 1)};
  if (way == 4) return {side * random.uniform(0, 3), random.uniform(-1, 1)};
  if (way == 5) return {side * random.log_uniform(1e-3, 700), random.uniform(-1, 1)};
  return {side * hard_alphas[random.index(hard_alphas.size())],
          face * hard_depths[random.index(hard_depths.size())]};
}

void keep_off_the_load(double& alpha, double& depth) {
  depth = std::clamp(depth, -1.0, 1.0);
  if (std::fabs(depth) == 1 && std::fabs(alpha) < nearest_on_the_face) alpha = nearest_on_the_face;
}

/// Sets those of the arguments that the quantity has.
void draw_point_of_sheet(Random& random, const NamedNumbers& x) {
  const auto has = [&](std::string_view name) {
    return std::ranges::find(x.arguments(), name, &Argument::name) != x.arguments().end();
  };
  InnerPoint at = draw_anywhere(random);
  keep_off_the_load(at.alpha, at.depth);
  x["alpha"] = at.alpha;
  x["depth"] = at.depth;
  if (has("eta")) {
    const double eta =
        random.chance(0.3) ? at.alpha * random.uniform(0.9, 1.1) : random.log_uniform(1e-3, 700);
    x["eta"] = random.chance(0.5) ? eta : -eta;
  }
  x["load"] = random.chance(0.5) ? 1 : 0;
  if (has("poisson"))
    x["poisson"] = random.chance(0.1) ? 0.5 : std::nextafter(-1.0, 0.0) + 1.5 * random.uniform();
}

Quantity in_sheet(Quantity entry) {
  return sampled(std::move(entry), draw_point_of_sheet,
                 [](NamedNumbers x) { keep_off_the_load(x["alpha"], x["depth"]); });
}

/// A function of a place, a load and more, as one of the numbers of their arguments.
auto at_place(auto function) {
  return [function](const auto& alpha, const auto& depth, const auto& load,
                    const auto&... more) -> decltype(function(alpha, depth, load_of(load), more...)) {
    return function(alpha, depth, load_of(load), more...);
  };
}

using RefStress = ref::Enclosure (*)(const Exact&, const Exact&, SheetLoad, int);

Quantity stress_entry(const char* name, double fast::SheetStresses::*part, RefStress by_ref,
                      double (FieldSize::*size)() const) {
  return in_sheet(entry_of(name, {"alpha", "depth", "load"}, at_place(by_ref),
                           at_place([part](double alpha, double depth, SheetLoad load) {
                             return fast::sheet_stresses(alpha, depth, load).*part;
                           }),
                           at_place([size](double alpha, double depth, SheetLoad load) {
                             return (FieldSize{alpha, depth, load}.*size)();
                           })));
}

/// The modulus of the root of the slowest residue term, the factor by which a derivative has a larger amplitude.
constexpr double slowest_root = 2.388;

Derivative derivative_of(double number) { return number == 0 ? Derivative::first : Derivative::second; }

/// kernel: the amplitude of the slowest residue term of the displacement's kernel.
Quantity slope_entry(const char* name, ref::Enclosure (*by_ref)(const Exact&, Derivative, int),
                     double (*by_fast)(double, Derivative), double (*kernel)(double)) {
  const auto keep_off = [](const NamedNumbers& x) {
    const double nearest = derivative_of(x["order"]) == Derivative::first ? nearest_on_the_face : 1e-150;
    if (std::fabs(x["alpha"]) < nearest) x["alpha"] = nearest;
  };
  return sampled(
      entry_of(
          name, {"alpha", "order"},
          [by_ref](const Exact& alpha, const Exact& order, int digits) {
            return by_ref(alpha, derivative_of(order.approximate()), digits);
          },
          [by_fast](double alpha, double order) { return by_fast(alpha, derivative_of(order)); },
          [kernel](double alpha, double order) {
            return std::pow(slowest_root, order + 1) * kernel(alpha) / std::numbers::pi;
          }),
      [keep_off](Random& random, const NamedNumbers& x) {
        x["alpha"] = draw_anywhere(random).alpha;
        x["order"] = static_cast<double>(random.index(2));
        keep_off(x);
      },
      keep_off);
}

}  // namespace

std::vector<Quantity> field_entries() {
  return {
      slope_entry("un.slope", ref::un_slope, fast::un_slope, envelope_I1),
      slope_entry("vn.slope", ref::vn_slope, fast::vn_slope, envelope_I3),
      slope_entry("vs.slope", ref::vs_slope, fast::vs_slope, envelope_r),
      stress_entry("sheet.sx", &fast::SheetStresses::across, ref::sheet_across, &FieldSize::across),
      stress_entry("sheet.sy", &fast::SheetStresses::along, ref::sheet_along, &FieldSize::along),
      stress_entry("sheet.txy", &fast::SheetStresses::shear, ref::sheet_shear, &FieldSize::shear),
      in_sheet(entry_of("sheet.u", {"alpha", "depth", "load", "poisson"}, at_place(ref::sheet_u),
                        at_place(fast::sheet_u),
                        at_place([](double alpha, double depth, SheetLoad load, double poisson) {
                          return FieldSize{alpha, depth, load}.u(poisson);
                        }))),
      in_sheet(entry_of("sheet.v", {"alpha", "depth", "load", "eta", "poisson"},
                        at_place([](const Exact& alpha, const Exact& depth, SheetLoad load, const Exact& eta,
                                    const Exact& poisson, int digits) {
                          return ref::sheet_v(alpha, eta, depth, load, poisson, digits);
                        }),
                        at_place([](double alpha, double depth, SheetLoad load, double eta, double poisson) {
                          return fast::sheet_v(alpha, eta, depth, load, poisson);
                        }),
                        at_place([](double alpha, double depth, SheetLoad load, double eta, double poisson) {
                          return FieldSize{alpha, depth, load}.v(eta, poisson);
                        })))};
}

}  // namespace nipref::verify
