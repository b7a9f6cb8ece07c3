#include <nipref/data/closest_name.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {
namespace {

/// All quantities in the order of the table. Each row has one entry.
std::vector<Quantity> gather() {
  std::map<std::string, Quantity> entries;
  for (auto* const group :
       {kernel_entries, field_entries, memory_entries, moving_load_entries, half_space_entries,
        transverse_half_space_entries, half_space_contact_entries, seed_sphere_entries, anisotropic_entries,
        material_entries, elastic_nip_entries, viscoelastic_nip_entries}) {
    for (Quantity& entry : group()) entries.emplace(entry.name, std::move(entry));
  }
  std::vector<Quantity> all;
  for (const Quantity& row : described_quantities()) {
    all.push_back(std::move(entries.at(row.name)));
    for (Argument& argument : all.back().arguments)
      if (!all.back().draw) argument.hard_values = hard_values(argument.kind);
  }
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
  refuse("quantity", name, "{}must be one that 'nipref list' shows{}{}", data::did_you_mean(name, names, 3),
         groups.empty() ? "" : ", or one of ", fmt::join(groups, ", "));
}

const Quantity* known_quantity(std::string_view name) {
  return item_with(catalogue(), &Quantity::name, name);
}

const Quantity& find_quantity(std::string_view name) {
  const Quantity* const found = known_quantity(name);
  if (found == nullptr) refuse_quantity(name);
  return *found;
}

}  // namespace nipref::verify
