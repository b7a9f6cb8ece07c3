// Inside the sheet, under one line load on each face.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <nipref/fast/sheet/field.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>
#include <nipref/verify/catalogue/sheet/internal/field_sizes.hpp>

namespace nipref::verify {
namespace {

using data::SheetLoad;
using fast::Accuracy;
using Arguments = std::span<const double>;
using Exacts = std::span<const ref::Exact>;

constexpr double field_promise = 8;
constexpr double nearest_on_the_face = 1e-300;

SheetLoad load_of(double number) { return number == 0 ? SheetLoad::normal : SheetLoad::shear; }
SheetLoad load_of(const ref::Exact& number) { return load_of(number.approximate()); }

Argument load_argument() { return {"load", ArgumentKind::choice, "normal", {}, {"normal", "shear"}}; }

Argument place_argument(std::string name) { return {std::move(name), ArgumentKind::position, {}, {}}; }
Argument depth_argument() { return {"depth", ArgumentKind::depth, {}, {}}; }
Argument ratio_argument() { return {"poisson", ArgumentKind::poisson, {}, {}}; }

/// Where fast goes over from closed forms to residues, and where those underflow.
constexpr std::array hard_alphas{0.0,  1e-300, 1e-16, 1e-8,  0.5,   0x1.3ffffffffffffp+0,
                                 1.25, 12.2,   100.0, 336.0, 354.0, 700.0};
constexpr std::array hard_depths{1.0, 1 - 0x1p-53, 0.9, 0.5, 0.5 - 0x1p-54, 1e-16, 1e-300, 0.0};

struct InnerPoint {
  double alpha, depth;
};

/// Towards the load along a line, on and just below the face, near the middle plane, far away, hard places.
InnerPoint draw_anywhere(Random& random) {
  const double side = random.chance(0.5) ? 1 : -1, face = random.chance(0.5) ? 1 : -1;
  switch (random.index(7)) {
    case 0:
    case 1: {
      const double distance = random.log_uniform(nearest_on_the_face * 2, 1);
      const double angle = random.uniform(0, std::numbers::pi / 2);
      return {side * distance * std::cos(angle), face * (1 - distance * std::sin(angle))};
    }
    case 2:
      return {side * random.log_uniform(1e-20, 10),
              face * (1 - std::ldexp(static_cast<double>(random.index(4)), -53))};
    case 3:
      return {side * random.log_uniform(1e-20, 10), face * random.log_uniform(nearest_on_the_face, 1)};
    case 4:
      return {side * random.uniform(0, 3), random.uniform(-1, 1)};
    case 5:
      return {side * random.log_uniform(1e-3, 700), random.uniform(-1, 1)};
    default:
      return {side * hard_alphas[random.index(hard_alphas.size())],
              face * hard_depths[random.index(hard_depths.size())]};
  }
}

double draw_ratio(Random& random) {
  return random.chance(0.1) ? 0.5 : std::nextafter(-1.0, 0.0) + 1.5 * random.uniform();
}

void keep_off_the_load(double& alpha, double& depth) {
  depth = std::clamp(depth, -1.0, 1.0);
  if (std::fabs(depth) == 1 && std::fabs(alpha) < nearest_on_the_face) alpha = nearest_on_the_face;
}

InnerPoint draw_place(Random& random) {
  InnerPoint at = draw_anywhere(random);
  keep_off_the_load(at.alpha, at.depth);
  return at;
}

Quantity field_entry(std::string name, std::string definition) {
  Quantity entry;
  entry.name = std::move(name);
  entry.definition = std::move(definition);
  entry.source = "thesis (3.19), (3.20), (4.3), (4.14)";
  entry.scale =
      "sum of the magnitudes of its parts: half-planes' fields up to |alpha| = 1.25, slowest residue terms, "
      "what does not decay";
  entry.promise = field_promise;
  entry.audit_points = 400;
  return entry;
}

using RefStress = ref::Enclosure (*)(const ref::Exact&, const ref::Exact&, SheetLoad, int);

Quantity stress_entry(std::string name, std::string definition, double fast::SheetStresses::*part,
                      RefStress by_ref, double (FieldSize::*size)() const) {
  Quantity entry = field_entry(std::move(name), std::move(definition));
  entry.unit = "1/half-thickness";
  entry.arguments = {place_argument("alpha"), depth_argument(), load_argument()};
  entry.by_ref = [by_ref](Exacts x, int digits) { return by_ref(x[0], x[1], load_of(x[2]), digits); };
  set_fast(entry,
           [part](Arguments x, Accuracy) { return fast::sheet_stresses(x[0], x[1], load_of(x[2])).*part; });
  entry.envelope = [size](Arguments x) { return (FieldSize{x[0], x[1], load_of(x[2])}.*size)(); };
  entry.draw = [](Random& random) {
    const InnerPoint at = draw_place(random);
    return Point{at.alpha, at.depth, random.chance(0.5) ? 1.0 : 0.0};
  };
  entry.keep_off = [](Point& x) { keep_off_the_load(x[0], x[1]); };
  return entry;
}

Quantity entry_u() {
  Quantity entry =
      field_entry("sheet.u",
                  "displacement along +x over theta1 + theta2 inside the sheet under a unit line load on "
                  "each face; at depth -1 un or us");
  entry.arguments = {place_argument("alpha"), depth_argument(), load_argument(), ratio_argument()};
  entry.by_ref = [](Exacts x, int digits) { return ref::sheet_u(x[0], x[1], load_of(x[2]), x[3], digits); };
  set_fast(entry, [](Arguments x, Accuracy) { return fast::sheet_u(x[0], x[1], load_of(x[2]), x[3]); });
  entry.envelope = [](Arguments x) { return FieldSize{x[0], x[1], load_of(x[2])}.u(x[3]); };
  entry.draw = [](Random& random) {
    const InnerPoint at = draw_place(random);
    return Point{at.alpha, at.depth, random.chance(0.5) ? 1.0 : 0.0, draw_ratio(random)};
  };
  entry.keep_off = [](Point& x) { keep_off_the_load(x[0], x[1]); };
  return entry;
}

Quantity entry_v() {
  Quantity entry =
      field_entry("sheet.v",
                  "displacement along +y over theta1 + theta2 inside the sheet under a unit line load on "
                  "each face, relative to the point eta of the middle plane; at depth +-1 vn or vs");
  entry.arguments = {place_argument("alpha"), place_argument("eta"), depth_argument(), load_argument(),
                     ratio_argument()};
  entry.by_ref = [](Exacts x, int digits) {
    return ref::sheet_v(x[0], x[1], x[2], load_of(x[3]), x[4], digits);
  };
  set_fast(entry, [](Arguments x, Accuracy) { return fast::sheet_v(x[0], x[1], x[2], load_of(x[3]), x[4]); });
  entry.envelope = [](Arguments x) { return FieldSize{x[0], x[2], load_of(x[3])}.v(x[1], x[4]); };
  entry.draw = [](Random& random) {
    const InnerPoint at = draw_place(random);
    const double eta =
        random.chance(0.3) ? at.alpha * random.uniform(0.9, 1.1) : random.log_uniform(1e-3, 700);
    return Point{at.alpha, random.chance(0.5) ? eta : -eta, at.depth, random.chance(0.5) ? 1.0 : 0.0,
                 draw_ratio(random)};
  };
  entry.keep_off = [](Point& x) { keep_off_the_load(x[0], x[2]); };
  return entry;
}

}  // namespace

std::vector<Quantity> field_entries() {
  return {
      stress_entry("sheet.sx",
                   "stress across the sheet, sigma_x, inside it under a unit line load on each face",
                   &fast::SheetStresses::across, ref::sheet_across, &FieldSize::across),
      stress_entry("sheet.sy",
                   "stress along the sheet, sigma_y, inside it under a unit line load on each face",
                   &fast::SheetStresses::along, ref::sheet_along, &FieldSize::along),
      stress_entry("sheet.txy", "shear stress, tau_xy, inside the sheet under a unit line load on each face",
                   &fast::SheetStresses::shear, ref::sheet_shear, &FieldSize::shear),
      entry_u(), entry_v()};
}

}  // namespace nipref::verify
