#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

std::vector<Quantity> gather() {
  std::vector<Quantity> all;
  const auto add = [&](std::string_view subject, std::initializer_list<std::vector<Quantity>> groups) {
    for (std::vector<Quantity> group : groups) {
      for (Quantity& quantity : group) quantity.subject = subject;
      std::ranges::move(group, std::back_inserter(all));
    }
  };
  add("sheet", {root_entries(), kernel_entries(), displacement_entries(), field_entries()});
  add("memory", {memory_entries(), moving_load_entries()});
  add("half_space", {half_space_entries(), transverse_half_space_entries(), half_space_contact_entries(),
                     elliptic_contact_entries(), seed_sphere_entries(), anisotropic_entries()});
  add("material", {material_entries()});
  add("elastic_nip", {elastic_nip_entries()});
  add("viscoelastic_nip", {viscoelastic_nip_entries()});
  return all;
}

}  // namespace

const std::vector<Quantity>& catalogue() {
  static const std::vector<Quantity> all = gather();
  return all;
}

void refuse_quantity(std::string_view name, const std::vector<std::string_view>& groups) {
  std::vector<std::string_view> names = groups;
  for (const Quantity& quantity : catalogue()) names.push_back(quantity.name);
  throw data::BadInput(
      "quantity", name,
      fmt::format("{}must be one that 'nipref list' shows{}{}", data::did_you_mean(name, names, 3),
                  groups.empty() ? "" : ", or one of ", fmt::join(groups, ", ")));
}

const Quantity* known_quantity(std::string_view name) {
  const auto found = std::ranges::find(catalogue(), name, &Quantity::name);
  return found == catalogue().end() ? nullptr : &*found;
}

const Quantity& find_quantity(std::string_view name) {
  const Quantity* const found = known_quantity(name);
  if (found == nullptr) refuse_quantity(name);
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
