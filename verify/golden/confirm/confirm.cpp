#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify {

Confirm confirmer_of(std::string_view quantity) {
  for (auto* const methods :
       {confirm::sheet_methods, confirm::field_methods, confirm::memory_methods, confirm::isotropic_methods,
        confirm::anisotropic_methods, confirm::nip_methods, confirm::material_methods}) {
    if (const auto found = methods().find(quantity); found != methods().end()) return found->second;
  }
  return {};
}

}  // namespace nipref::verify
