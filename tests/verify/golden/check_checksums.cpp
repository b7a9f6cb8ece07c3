#include <nipref/verify/golden/check.hpp>

#include "support/golden_folder.hpp"
#include "support/test.hpp"

using namespace nipref;

TEST_CASE("SHA-256 of the standard's own examples") {
  // FIPS 180-4 examples, as NIST gives them.
  CHECK(verify::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(verify::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_CASE("checksums are read as they are written, and what are none are refused") {
  const GoldenFolder folder;
  verify::Checksums sums;
  sums.set("I1.csv", "abc");
  std::ofstream(folder.file("SHA256SUMS")) << sums.text();
  CHECK(verify::Checksums::of(folder.path()).by_name() == sums.by_name());
  CHECK(verify::Checksums::of("/nowhere").by_name().empty());
  std::ofstream(folder.file("SHA256SUMS")) << "abc  I1.csv\n";
  CHECK_THROWS_AS(verify::Checksums::of(folder.path()), data::BadInput);
}
