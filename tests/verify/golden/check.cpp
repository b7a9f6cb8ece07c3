#include <nipref/data/input_file.hpp>
#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/golden/check.hpp>

#include "support/golden_folder.hpp"

using namespace nipref;
using verify::GoldenFault;
using verify::Quantity;

namespace {

std::vector<GoldenFault> faults_of(const verify::CheckedGolden& checked) {
  std::vector<GoldenFault> faults;
  for (const verify::GoldenFailure& failure : checked.failures) faults.push_back(failure.fault);
  return faults;
}

verify::GoldenFile golden(const char* quantity) { return verify::read_golden(verify::golden_path(quantity)); }

/// The file with its last `rows` rows only.
verify::GoldenFile last_of(verify::GoldenFile file, std::ptrdiff_t rows) {
  file.rows.erase(file.rows.begin(), file.rows.end() - rows);
  return file;
}

}  // namespace

TEST_CASE("golden values are what they were: every file to the last character, and values in steps") {
  CHECK(verify::check_folder(data::golden_directory()).empty());
  for (const Quantity& quantity : verify::catalogue()) {
    CAPTURE(quantity.name);
    if (!quantity.family.empty()) continue;
    const std::string bytes = data::text_of_input_file(verify::golden_path(quantity.name), "file");
    CHECK(verify::checksums_of(data::golden_directory()).at(quantity.name + ".csv") == verify::sha256(bytes));
    verify::GoldenFile file = verify::read_golden(verify::golden_path(quantity.name));
    // One row is enough if a value takes seconds. .ci/thorough checks as `golden check` does.
    const std::size_t step = quantity.audit_points >= 20'000 ? 20
                             : quantity.audit_points >= 20   ? 80
                                                             : file.rows.size();
    const verify::CheckOptions options{false, is_thorough() ? 1 : step};
    const verify::CheckedGolden checked = verify::check_rows(quantity, file, options);
    CHECK(checked.recomputed >= 1);
    for (const verify::GoldenFailure& failure : checked.failures) FAIL_CHECK(failure.what);
  }
}

TEST_CASE("fast with a perturbed coefficient is found by golden values, the others are not blamed") {
  const Quantity& quantity = verify::find_quantity("I5");
  Quantity damaged = quantity;
  // The error is in the first branch alone, and of four units in the last place.
  damaged.by_fast = [by_fast = quantity.by_fast](std::span<const double> x, fast::Accuracy accuracy) {
    const double value = by_fast(x, accuracy);
    return std::abs(x[0]) < 0.1 ? value * (1 + 0x1p-50) : value;
  };
  const verify::GoldenFile file = golden("I5");
  CHECK(verify::check_rows(quantity, file, {}).kept());
  const verify::CheckedGolden checked = verify::check_rows(damaged, file, {});
  CHECK(checked.failures.size() > 20);
  for (const verify::GoldenFailure& failure : checked.failures) {
    CHECK(failure.fault == GoldenFault::wrong);
    CHECK(contains(failure.what, "fast is"));
    CHECK(std::abs(file.rows[*failure.row - 1].arguments[0]) < 0.1);
  }
}

TEST_CASE("a reference that moves by less than any double sees is found") {
  const Quantity& quantity = verify::find_quantity("I1");
  Quantity moved = quantity;
  moved.by_ref = [by_ref = quantity.by_ref](std::span<const ref::Exact> x, int digits) {
    ref::Estimate reference = by_ref(x, digits);
    ref::Float step = ref::zero_of_bits(64);
    mpfr_mul_d(ref::raw(step), ref::raw(reference.value), 1e-45, MPFR_RNDN);
    mpfr_add(ref::raw(reference.value), ref::raw(reference.value), ref::raw(step), MPFR_RNDN);
    return reference;
  };
  const verify::CheckedGolden checked = verify::check_rows(moved, last_of(golden("I1"), 10), {});
  REQUIRE(checked.failures.size() == 10);
  CHECK(checked.failures.front().fault == GoldenFault::wrong);
  CHECK(contains(checked.failures.front().what, "the reference is"));
}

TEST_CASE("a bound too wide to say anything is told, and not wrong") {
  verify::GoldenFile file = last_of(golden("I1"), 3);
  file.rows[1].numbers[0].bound = "1e-3";
  const verify::CheckedGolden checked = verify::check_rows(file.quantity(), file, {});
  CHECK(faults_of(checked) == std::vector{GoldenFault::too_wide});
  CHECK(checked.failures.front().row == 2);
  Quantity coarse = file.quantity();
  coarse.by_ref = [by_ref = coarse.by_ref](std::span<const ref::Exact> x, int digits) {
    ref::Estimate reference = by_ref(x, digits);
    mpfr_set_d(ref::raw(reference.error), 1, MPFR_RNDU);
    return reference;
  };
  CHECK(faults_of(verify::check_rows(coarse, last_of(golden("I1"), 1), {})) ==
        std::vector{GoldenFault::too_wide});
}

TEST_CASE("any character that is changed in a golden file or its checksum is found") {
  const verify::GoldenFile file = last_of(golden("I2"), 1);
  const std::string text = verify::golden_text(file);
  const GoldenFolder folder;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder.file(name), std::ios::binary) << bytes;
  };
  verify::Checksums sums;
  sums["I2.csv"] = verify::sha256(text);
  write("SHA256SUMS", verify::checksums_text(sums));
  write("I2.csv", text);
  CHECK(verify::check_golden(folder.file("I2.csv"), {}).kept());
  for (std::size_t i = 0; i < text.size(); i += 3) {
    std::string changed = text;
    changed[i] = changed[i] == '1' ? '2' : '1';
    write("I2.csv", changed);
    CAPTURE(changed);
    const auto faults = faults_of(verify::check_golden(folder.file("I2.csv"), {}));
    REQUIRE_FALSE(faults.empty());
    CHECK(faults.front() == GoldenFault::text_changed);
  }
  write("I2.csv", text);
  std::string other = verify::checksums_text(sums);
  other[5] = other[5] == '1' ? '2' : '1';
  write("SHA256SUMS", other);
  CHECK(faults_of(verify::check_golden(folder.file("I2.csv"), {})) == std::vector{GoldenFault::text_changed});
}

TEST_CASE("files that checksums do not list or that are gone are found, one's own file needs none") {
  const verify::GoldenFile file = last_of(golden("I2"), 1);
  const GoldenFolder folder;
  const auto check = [&](const std::string& what) {
    const auto found = verify::check_folder(folder.path());
    REQUIRE(found.size() == (what.empty() ? 0 : 1));
    if (!what.empty()) CHECK(found.front().what == what);
  };
  check("");
  std::ofstream(folder.file("I2.csv")) << verify::golden_text(file);
  check("SHA256SUMS does not list I2.csv");
  std::filesystem::rename(folder.file("I2.csv"), folder.file("mine.csv"));
  const verify::CheckedGolden mine = verify::check_golden(folder.file("mine.csv"), {});
  CHECK(mine.kept());
  CHECK_FALSE(mine.hashed);
  std::filesystem::remove(folder.file("mine.csv"));
  verify::Checksums sums;
  sums["I3.csv"] = verify::sha256("x");
  std::ofstream(folder.file("SHA256SUMS")) << verify::checksums_text(sums);
  check("SHA256SUMS lists I3.csv, which is not there");
}

TEST_CASE("checksums are read as they are written, and what are none are refused") {
  const GoldenFolder folder;
  verify::Checksums sums;
  sums["I1.csv"] = verify::sha256("abc");
  std::ofstream(folder.file("SHA256SUMS")) << verify::checksums_text(sums);
  CHECK(verify::checksums_of(folder.path()) == sums);
  CHECK(verify::checksums_of("/nowhere").empty());
  std::ofstream(folder.file("SHA256SUMS")) << "abc  I1.csv\n";
  CHECK_THROWS_AS(verify::checksums_of(folder.path()), data::BadInput);
}
