#include <nipref/verify/golden/confirm/confirm.hpp>

namespace nipref::verify {

Confirm confirmer_of(std::string_view quantity) {
  using namespace confirm;
  static const Methods all = [] {
    Methods joined;
    for (auto* const methods : {sheet_methods, field_methods, memory_methods, isotropic_methods,
                                anisotropic_methods, nip_methods, material_methods})
      joined.merge(methods());
    return joined;
  }();
  const auto found = all.find(quantity);
  return found == all.end() ? Confirm() : found->second;
}

}  // namespace nipref::verify
