#include <nipref/verify/golden/confirm/anisotropic.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/confirm/field.hpp>
#include <nipref/verify/golden/confirm/isotropic.hpp>
#include <nipref/verify/golden/confirm/material.hpp>
#include <nipref/verify/golden/confirm/memory.hpp>
#include <nipref/verify/golden/confirm/nip.hpp>
#include <nipref/verify/golden/confirm/sheet.hpp>
#include <nipref/verify/golden/confirm/transverse.hpp>

namespace nipref::verify {

Confirm found_in(const Methods& methods, std::string_view quantity) {
  const auto found = methods.find(quantity);
  return found == methods.end() ? Confirm() : found->second;
}

Confirm confirmer_of(std::string_view quantity) {
  for (auto* const of_subject :
       {confirm::of_sheet, confirm::of_field, confirm::of_memory, confirm::of_isotropic,
        confirm::of_transverse, confirm::of_anisotropic, confirm::of_nip, confirm::of_material}) {
    if (Confirm found = of_subject(quantity)) return found;
  }
  return {};
}

}  // namespace nipref::verify
