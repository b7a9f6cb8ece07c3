// The field inside the sheet under one line load on each face.

#include <nipref/fast/sheet/field.hpp>
#include <nipref/ref/sheet/field.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

using data::Derivative;
using data::SheetLoad;
using ref::Exact;

SheetLoad load_of(double number) { return number == 0 ? SheetLoad::normal : SheetLoad::shear; }
SheetLoad load_of(const ref::Exact& number) { return load_of(number.approximate()); }

/// Makes a function of numbers from a function of a place, a load and more: the load is given as a number.
auto at_place(auto function) {
  return [function](const auto& alpha, const auto& depth, const auto& load,
                    const auto&... more) -> decltype(function(alpha, depth, load_of(load), more...)) {
    return function(alpha, depth, load_of(load), more...);
  };
}

using RefStress = ref::Enclosure (*)(const Exact&, const Exact&, SheetLoad, int);

Quantity stress_entry(const char* name, double fast::SheetStresses::*part, RefStress by_ref) {
  return entry_of(name, {"alpha", "depth", "load"}, at_place(by_ref),
                  at_place([part](double alpha, double depth, SheetLoad load) {
                    return fast::sheet_stresses(alpha, depth, load).*part;
                  }));
}

Derivative derivative_of(double number) { return number == 0 ? Derivative::first : Derivative::second; }

Quantity slope_entry(const char* name, ref::Enclosure (*by_ref)(const Exact&, Derivative, int),
                     double (*by_fast)(double, Derivative)) {
  return entry_of(
      name, {"alpha", "order"},
      [by_ref](const Exact& alpha, const Exact& order, int digits) {
        return by_ref(alpha, derivative_of(order.approximate()), digits);
      },
      [by_fast](double alpha, double order) { return by_fast(alpha, derivative_of(order)); });
}

}  // namespace

std::vector<Quantity> field_entries() {
  return {slope_entry("un.slope", ref::un_slope, fast::un_slope),
          slope_entry("vn.slope", ref::vn_slope, fast::vn_slope),
          slope_entry("vs.slope", ref::vs_slope, fast::vs_slope),
          stress_entry("sheet.sx", &fast::SheetStresses::across, ref::sheet_across),
          stress_entry("sheet.sy", &fast::SheetStresses::along, ref::sheet_along),
          stress_entry("sheet.txy", &fast::SheetStresses::shear, ref::sheet_shear),
          entry_of("sheet.u", {"alpha", "depth", "load", "poisson"}, at_place(ref::sheet_u),
                   at_place(fast::sheet_u)),
          entry_of("sheet.v", {"alpha", "depth", "load", "eta", "poisson"},
                   at_place([](const Exact& alpha, const Exact& depth, SheetLoad load, const Exact& eta,
                               const Exact& poisson, int digits) {
                     return ref::sheet_v(alpha, eta, depth, load, poisson, digits);
                   }),
                   at_place([](double alpha, double depth, SheetLoad load, double eta, double poisson) {
                     return fast::sheet_v(alpha, eta, depth, load, poisson);
                   }))};
}

}  // namespace nipref::verify
