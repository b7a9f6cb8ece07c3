#include <nipref/fast/memory/convolutions.hpp>
#include <nipref/ref/memory/convolutions.hpp>
#include <nipref/verify/catalogue/internal/entries.hpp>

namespace nipref::verify {

std::vector<Quantity> memory_entries() {
  const auto wave = [](const char* name, auto by_ref, auto by_fast) {
    return entry_of(name, {"lambda", "a", "b", "t", "T"}, by_ref, by_fast);
  };
  const auto sign = [](const char* name, auto by_ref, auto by_fast) {
    return entry_of(name, {"gamma0", "gamma", "lambda", "t", "T"}, by_ref, by_fast);
  };
  return {wave("J1", ref::J1, fast::J1), wave("J2", ref::J2, fast::J2), wave("J3", ref::J3, fast::J3),
          wave("J4", ref::J4, fast::J4), sign("J5", ref::J5, fast::J5), sign("J6", ref::J6, fast::J6)};
}

}  // namespace nipref::verify
