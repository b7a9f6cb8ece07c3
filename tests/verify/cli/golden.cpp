#include <nipref/verify/catalogue/catalogue.hpp>

#include "support/golden_folder.hpp"
#include "support/json_schema.hpp"
#include "support/run_nipref.hpp"

namespace {

using nlohmann::json;

/// Changes the first place where `from` stands.
void edit(const std::filesystem::path& path, const std::string& from, const std::string& to) {
  std::string text = text_of_file(path);
  REQUIRE(contains(text, from));
  text.replace(text.find(from), from.size(), to);
  std::ofstream(path) << text;
}

int status_in(const std::filesystem::path& folder, const std::string& command) {
  return WEXITSTATUS(std::system(("cd '" + folder.string() + "' && " + command).c_str()));
}

/// An answer that fits the schema.
json answer(const std::string& arguments, const std::string& definition, int status) {
  const json found = answer_to(arguments, status);
  CHECK(answer_schema().misfit(found, definition) == "");
  return found;
}

}  // namespace

TEST_CASE("golden: what is made is kept, what is changed is told and mended") {
  const GoldenFolder folder;
  const json made =
      answer("golden make I2 root.re --points 6 --digits 30 --seed 5 --in-place", "golden_make", 0);
  CHECK(made["files"].size() == 2);
  CHECK(made["files"][0]["rows"] == 6);
  CHECK(status_in(folder.path(), "sha256sum -c SHA256SUMS >/dev/null") == 0);
  const json kept = answer("golden check root.re I2", "golden_check", 0);
  CHECK(contains(run("golden check I2 --every 50").out, "recomputed by the reference: PASS\n"));
  CHECK(kept["files"].size() == 2);
  CHECK(kept["files"][0]["hashed"] == true);
  CHECK(answer("golden list I2 I3", "golden_list", 0)["missing"] == json{"I3"});
  const json of_all = answer("golden check", "golden_check", 1);
  const auto is_of_contacts = [](const nipref::verify::Quantity& quantity) {
    return !quantity.family.empty();
  };
  const auto of_contacts =
      static_cast<std::size_t>(std::ranges::count_if(nipref::verify::catalogue(), is_of_contacts));
  CHECK(of_all["failures"].size() + 2 + of_contacts == nipref::verify::catalogue().size());
  CHECK(of_all["failures"][0]["fault"] == "missing");

  SUBCASE("a digit that is changed is found, by its checksum and by the reference") {
    edit(folder.file("I2.csv"), "1.5707963267948966192313216916", "1.5707963267948966192313216917");
    const json changed = answer("golden check I2", "golden_check", 1);
    CHECK(changed["files"][0]["failures"][0]["fault"] == "text-changed");
    CHECK(changed["files"][0]["failures"][1]["fault"] == "wrong");
    CHECK(contains(run("golden check root.re I2").out,
                   "12 golden values: 1 wrong, 0 too-wide, 1 text-changed, 0 missing"));
    edit(folder.file("I2.csv"), "# scale: ", "# scale: formerly ");
    const json updated = answer("golden update I2 --dirty --in-place", "golden_update", 0);
    REQUIRE(updated["files"][0]["changed"].size() == 1);
    CHECK(updated["files"][0]["changed"][0]["why"] == "another value");
    CHECK(run("golden check root.re I2").status == 0);
    const std::string after = text_of_file(folder.file("I2.csv"));
    CHECK(contains(after, "# updated: 1 rows by "));
    CHECK(!contains(after, "formerly"));
    CHECK(contains(run("golden update I2 --dirty --in-place").out, "0 of 6 rows changed"));
    CHECK(text_of_file(folder.file("I2.csv")) == after);
    const std::string all = run("golden update I2 --dirty --in-place --all").out;
    for (const char* part : {"\n- ", "\n+ ", "6 of 6 rows changed"}) CHECK(contains(all, part));
  }
  SUBCASE("a file by its path, and one that cannot be read") {
    CHECK(run("golden check '" + folder.file("I2.csv").string() + "'").status == 0);
    std::ofstream(folder.file("I2.csv")) << "nothing";
    CHECK(answer("golden check root.re I2", "golden_check", 1)["files"][1]["quantity"].is_null());
  }
}

TEST_CASE("golden: where new values go is said, and no file that is there gets fewer rows") {
  const GoldenFolder folder;
  const ScratchFolder elsewhere;
  const std::filesystem::path file = elsewhere.path() / "mine.csv";
  const std::string six = "golden make I2 --points 6 --digits 30", to_file = " -o '" + file.string() + "'";
  check_call_refused(six, "output = (missing): must be a file or a folder, or --in-place given");
  check_call_refused("golden update I2 --dirty", "output = (missing)");
  check_call_refused(six + to_file + " --in-place", "must be left out, or --in-place");
  check_call_refused(six + " -o '" + folder.path().string() + "'", "--in-place writes to nipref's own files");
  check_call_refused("golden update I1 --dirty --in-place", "must be a file that exists");
  CHECK(std::filesystem::is_empty(folder.path()));

  CHECK(run(six + " --in-place").status == 0);
  const std::string own = text_of_file(folder.file("I2.csv"));
  const std::string five = "golden make I2 --points 5 --digits 30";
  check_call_refused(five + " --in-place", "must not lose rows: it has 6 and would get 5");
  CHECK(text_of_file(folder.file("I2.csv")) == own);

  CHECK(run(six + to_file).status == 0);
  check_call_refused(five + to_file, "must not lose rows: it has 6 and would get 5");
  check_call_refused("golden make I3 --points 7" + to_file,
                     "must be one of I3, or none yet: it has values of I2");
  check_call_refused("golden make I2 I3" + to_file, "must be a folder: there are several quantities");
  CHECK(text_of_file(file) == own);
  // Nothing but the file is there, and of a folder all.
  CHECK(std::distance(std::filesystem::directory_iterator(elsewhere.path()), {}) == 1);
  CHECK(run(six + " -o '" + (elsewhere.path() / "all/").string() + "'").status == 0);
  CHECK(text_of_file(elsewhere.path() / "all/I2.csv") == own);
  CHECK(status_in(elsewhere.path() / "all", "sha256sum --quiet -c SHA256SUMS") == 0);
  edit(folder.file("I2.csv"), "1.5707963267948966192313216916", "1.5707963267948966192313216917");
  const std::string changed = text_of_file(folder.file("I2.csv"));
  CHECK(run("golden update I2 --dirty" + to_file).status == 0);
  CHECK(text_of_file(folder.file("I2.csv")) == changed);
  CHECK(contains(text_of_file(file), "# updated: 1 rows by "));
  const json commit = answer_to("--version")["nipref"]["commit"];
  if (commit.is_null() || commit.get<std::string>().ends_with("-dirty"))
    check_call_refused("golden update I1", "must be given: this program was built from a tree that differs");
}

TEST_CASE("golden: an exported header compiles in a stranger's program, whose I1 it finds right and wrong") {
  const ScratchFolder folder;
  const json told =
      answer("golden export I1 contacts-frictionless --format cpp -o '" + folder.path().string() + "'",
             "golden_export", 0);
  CHECK(told["version"] == json::parse(run("--version --json").out)["golden"]);
  // I1 is -log|alpha| and a constant but for terms of the order alpha^2 log alpha.
  folder.write("stranger.cpp", R"(
    #include <cmath>
    #include "I1.hpp"
    #include "contacts-frictionless.hpp"
    static_assert(nipref_golden::contacts_frictionless[0].load_bound > 0);
    int main() {
      int rows = 0, wrong = 0;
      for (const auto& row : nipref_golden::I1) {
        if (std::fabs(row.alpha) > 1e-7) continue;
        const double mine = -std::log(std::fabs(row.alpha)) - CONSTANT;
        ++rows, wrong += !(std::fabs(mine - row.value) <= 1e-12 * row.scale);
      }
      return rows < 10 ? 2 : wrong > 0;
    })");
  for (const auto& [constant, status] : {std::pair{"0.3516753926187", 0}, {"0.3516753936187", 1}}) {
    const std::string compiler = "c++ -std=c++17 -Wall -Werror -D CONSTANT=";
    REQUIRE(status_in(folder.path(), compiler + constant + " stranger.cpp -o it") == 0);
    CHECK(status_in(folder.path(), "./it") == status);
  }
  const std::string text = text_of_file(nipref::data::golden_directory() / "I1.csv");
  for (const std::string format : {"csv", "json"}) {
    const std::filesystem::path file = folder.path() / ("I1." + format);
    answer("golden export I1 --format " + format + " -o '" + file.string() + "'", "golden_export", 0);
    if (format == "csv") CHECK(text_of_file(file).ends_with(text));
    if (format == "json") CHECK(json::parse(text_of_file(file))["columns"]["value"]["double"].size() == 250);
  }
}
