#include <nipref/data/directory.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/golden/confirm/confirm.hpp>
#include <nipref/verify/golden/contacts.hpp>

#include "support/scratch.hpp"

using namespace nipref;
using verify::GoldenFile;

namespace {

GoldenFile contacts(const char* kind) { return verify::read_golden(verify::golden_path(kind)); }

/// The contact with these values of its keys.
GoldenFile one_of(GoldenFile file, const verify::Assignments& keys) {
  std::erase_if(file.rows, [&](const verify::GoldenRow& row) { return row.keys != keys; });
  REQUIRE(file.rows.size() == 1);
  return file;
}

GoldenFile unit_contact() {
  return one_of(contacts("contacts-frictionless"), {{"contact.length", "1"}, {"material.poisson", "0.2"}});
}

}  // namespace

TEST_CASE("there are at least 200 golden contacts of each kind, each confirmed, none twice") {
  std::map<std::string, std::size_t> rows;
  for (const std::string& kind : verify::contact_kinds()) {
    CAPTURE(kind);
    const GoldenFile file = contacts(kind.c_str());
    CHECK(file.entry("quantity") == kind);
    CHECK(file.entry("tree") == "clean");
    CHECK(file.entry("commit").size() == 40);
    std::set<verify::Assignments> keys;
    std::size_t by_second_method = 0;
    for (const verify::GoldenRow& row : file.rows) {
      keys.insert(row.keys);
      CHECK(row.confirmed_by.starts_with("fast to "));
      if (contains(row.confirmed_by, "; ")) ++by_second_method;
    }
    CHECK(keys.size() == file.rows.size());
    // Contacts are left out if not all their digits are known.
    CHECK(keys.size() >= 0.95 * static_cast<double>(verify::swept_by(verify::contact_scene(kind)).size()));
    CHECK(10 * by_second_method >= file.rows.size());
    const bool is_rolling_sheet = kind.starts_with("contacts-rolling-") && kind != "contacts-rolling-sphere";
    rows[is_rolling_sheet ? "contacts-rolling-sheets" : kind] += file.rows.size();
    CHECK(verify::golden_text(file) == data::text_of_input_file(verify::golden_path(kind), "file"));
  }
  for (const auto& [kind, count] : rows) {
    CAPTURE(kind);
    CHECK(count >= 200);
  }
}

TEST_CASE("golden contacts are what they were: every 40th by fast, one of each kind by the reference") {
  for (const std::string& kind : verify::contact_kinds()) {
    CAPTURE(kind);
    CHECK(verify::checksums_of(data::golden_directory()).at(kind + ".csv") ==
          verify::sha256(data::text_of_input_file(verify::golden_path(kind), "file")));
    GoldenFile file = contacts(kind.c_str());
    for (const auto& found : verify::check_contacts(file, {false, is_thorough() ? 1U : 40U}).failures)
      FAIL_CHECK(found.what);
  }
}

TEST_CASE("a golden contact changed in its 17th digit is found by the reference, in its 12th by fast") {
  GoldenFile file = unit_contact();
  REQUIRE(verify::check_contacts(file, {}).kept());
  std::string& load = file.rows[0].numbers[0].value;
  const std::string right = load;
  const auto faults_at = [&](std::size_t digit) {
    load = right;
    load[digit + 1] = load[digit + 1] == '9' ? '8' : static_cast<char>(load[digit + 1] + 1);
    return verify::check_contacts(file, {}).failures.size();
  };
  CHECK(faults_at(17) == 1);
  CHECK(faults_at(11) == 2);
  load = right;
  file.rows[0].numbers[0].bound = "1e-20";
  CHECK(verify::check_contacts(file, {}).failures.at(0).fault == verify::GoldenFault::too_wide);
}

TEST_CASE("second methods solve contacts as the reference does, and say where they do not reach") {
  const auto is_reached = [](const char* kind, const verify::Assignments& keys) {
    return static_cast<bool>(verify::second_solver(data::load_scene(verify::contact_scene(kind), keys)));
  };
  for (const char* const kind : {"contacts-frictionless", "contacts-full-friction"}) {
    CHECK(is_reached(kind, {{"contact.length", "4"}, {"material.poisson", "0.2"}}));
    CHECK_FALSE(is_reached(kind, {{"contact.length", "5"}, {"material.poisson", "0.2"}}));
  }
}

TEST_CASE("a file of golden contacts that is none is refused with line and column") {
  const std::string text = verify::golden_text(unit_contact());
  const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
    std::string changed = text;
    REQUIRE(contains(changed, from));
    const ScratchFile file(changed.replace(changed.find(from), from.size(), to));
    return refusal_of([&] { return verify::read_golden(file.path()); });
  };
  CHECK(refusal("load,", "load,") == "accepted");
  CHECK(contains(refusal("quantity: contacts-frictionless", "quantity: contacts-soft"), "must be one that"));
  CHECK(contains(refusal(",load,", ",force,"), "must be the column load"));
  CHECK(contains(refusal(",proven,", ",certain,"), "must be proven or estimated"));
  CHECK(contains(refusal("e-", "f-"), "must be a finite decimal number"));
}
