#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/cli/house.hpp>

#include "support/scratch.hpp"

using nipref::verify::touched_subjects;
using Subjects = std::set<std::string>;

TEST_CASE("a changed file touches the quantities that are computed from it") {
  CHECK(touched_subjects({"fast/sheet/arithmetic/piece.hpp"}) ==
        Subjects{"contacts", "elastic_nip", "memory", "sheet", "viscoelastic_nip"});
  CHECK(touched_subjects({"ref/memory/convolutions.cpp"}) ==
        Subjects{"contacts", "memory", "viscoelastic_nip"});
  CHECK(touched_subjects({"fast/half_space/elliptic.cpp"}) == Subjects{"contacts", "half_space"});
  CHECK(touched_subjects({"fast/elastic_nip/converged.cpp", "ref/viscoelastic_nip/converged.hpp"}) ==
        Subjects{"contacts", "elastic_nip", "viscoelastic_nip"});
  // Convolutions and rolling contacts take their compliances from the material.
  CHECK(touched_subjects({"ref/material/moduli.cpp"}) ==
        Subjects{"contacts", "material", "memory", "viscoelastic_nip"});
  CHECK(touched_subjects({"verify/catalogue/memory/convolutions.cpp"}) == Subjects{"memory"});
  CHECK(
      touched_subjects({"README.md", "verify/cli/eval.cpp", "tests/house.cpp", "data/tables/thesis-VII.csv"})
          .empty());
  for (const char* const file : {"fast/number/two_words.hpp", "ref/CMakeLists.txt", "CMakeLists.txt",
                                 "verify/catalogue/quantity.hpp"}) {
    CAPTURE(file);
    CHECK(touched_subjects({file}).size() == 7);
  }
}

TEST_CASE("every quantity has a subject that a file can touch") {
  const Subjects all = touched_subjects({"CMakeLists.txt"});
  for (const auto& quantity : nipref::verify::catalogue()) {
    CAPTURE(quantity.name);
    CHECK(all.contains(std::string(quantity.subject)));
  }
}

TEST_CASE("changed files are those that git sees, new ones too") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  const fs::path tree = scratch.path(), before = fs::current_path();
  fs::create_directories(tree / "fast/memory");
  std::ofstream(tree / "fast/memory/old.cpp") << "1";
  std::ofstream(tree / "README.md") << "1";
  fs::current_path(tree);
  const bool has_git =
      std::system("git init -q . && git add . && git -c user.name=a -c user.email=b commit -q -m c") == 0;
  if (has_git) {
    CHECK(nipref::verify::changed_files("HEAD").empty());
    std::ofstream(tree / "fast/memory/old.cpp") << "2";
    std::ofstream(tree / "fast/memory/new.cpp") << "3";
    fs::current_path(tree / "fast");
    CHECK(nipref::verify::changed_files("HEAD") ==
          std::vector<std::string>{"fast/memory/old.cpp", "fast/memory/new.cpp"});
    CHECK_THROWS(static_cast<void>(nipref::verify::changed_files("no'such")));
  } else {
    MESSAGE("skipped: git cannot be run");
  }
  fs::current_path(before);
}
