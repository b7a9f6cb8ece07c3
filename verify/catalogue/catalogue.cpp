#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

std::vector<Quantity> gather() {
  std::vector<Quantity> all;
  for (auto group : {root_entries(), kernel_entries(), displacement_entries(), memory_entries(),
                     moving_load_entries(), half_space_entries(), transverse_half_space_entries(),
                     half_space_contact_entries(), elliptic_contact_entries(), seed_sphere_entries()}) {
    std::move(group.begin(), group.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

const std::vector<Quantity>& catalogue() {
  static const std::vector<Quantity> all = gather();
  return all;
}

std::string quantity_names() {
  std::vector<std::string_view> names;
  for (const Quantity& quantity : catalogue()) names.push_back(quantity.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

const Quantity& find_quantity(std::string_view name) {
  const auto& all = catalogue();
  const auto found = std::ranges::find(all, name, &Quantity::name);
  if (found == all.end()) throw data::BadInput("quantity", name, "must be one of " + quantity_names());
  return *found;
}

std::vector<const Quantity*> select_quantities(const std::vector<std::string>& names) {
  std::vector<const Quantity*> selected;
  for (const std::string& name : names) selected.push_back(&find_quantity(name));
  if (names.empty()) {
    for (const Quantity& quantity : catalogue()) selected.push_back(&quantity);
  }
  return selected;
}

}  // namespace nipref::verify
