#include <nipref/verify/cli/house.hpp>

namespace nipref::verify {

const Arrows& room_arrows() {
  static const Arrows arrows{
      {"data", {}}, {"ref", {"data"}}, {"fast", {"data"}}, {"verify", {"data", "ref", "fast"}}};
  return arrows;
}

const std::map<std::string, Arrows>& subject_arrows() {
  static const std::map<std::string, Arrows> arrows{
      {"data",
       {{"", {}},
        {"number", {}},
        {"material", {""}},
        {"problem", {"", "material"}},
        {"scene", {"", "material", "problem"}},
        {"table", {""}}}},
      {"ref",
       {{"number", {}},
        {"material", {"number"}},
        {"sheet", {"number"}},
        {"memory", {"number", "sheet", "material"}},
        {"nip", {"number"}},
        {"elastic_nip", {"number", "sheet", "nip"}},
        {"viscoelastic_nip", {"number", "sheet", "material", "memory", "nip"}},
        {"half_space", {"number"}}}},
      {"fast",
       {{"number", {}},
        {"material", {"number"}},
        {"sheet", {"number"}},
        {"memory", {"number", "sheet", "material"}},
        {"nip", {"number", "sheet"}},
        {"elastic_nip", {"number", "sheet", "nip"}},
        {"viscoelastic_nip", {"number", "sheet", "material", "memory", "nip"}},
        {"half_space", {"number"}}}},
      {"verify",
       {{"support", {}},
        {"catalogue", {"support"}},
        {"audit", {"support", "catalogue", "solve"}},
        {"solve", {"support", "catalogue"}},
        {"replay", {"support", "catalogue"}},
        {"bench", {"support", "catalogue", "replay", "audit", "grade"}},
        {"grade", {"support", "catalogue", "audit"}},
        {"witness", {"support", "solve"}},
        {"seeds", {"support", "catalogue"}},
        {"figures", {"support", "catalogue", "replay"}},
        {"c_interface", {"support", "catalogue"}},
        {"golden", {"support", "catalogue", "audit"}},
        {"report",
         {"support", "catalogue", "audit", "golden", "grade", "replay", "bench", "solve", "witness", "seeds",
          "figures"}},
        {"cli",
         {"support", "catalogue", "audit", "golden", "grade", "solve", "replay", "bench", "witness", "seeds",
          "figures", "report"}},
        {"mpi", {"support", "audit", "cli"}}}},
  };
  return arrows;
}

}  // namespace nipref::verify
