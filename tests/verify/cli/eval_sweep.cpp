#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

using nlohmann::json;

namespace {

std::vector<std::string> csv_lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST_CASE("a sweep's row is what eval says at its arguments, and rows come in the order of their arguments") {
  const json columns =
      answer_to("eval I6 alpha=0x1p-3,7.5 eta=0.1..10:log --points 40 --digits 20").at("columns");
  REQUIRE(columns.at("alpha").size() == 80);
  for (const std::size_t row : {0U, 17U, 39U, 40U, 79U}) {
    CAPTURE(row);
    CHECK(columns["alpha"][row] == (row < 40 ? "0x1p-3" : "7.5"));
    const auto eta = columns["eta"][row].get<std::string>();
    const Outcome single = run("eval I6 alpha=" + columns["alpha"][row].get<std::string>() + " eta=" + eta +
                               " --path fast --json");
    const json answer = json::parse(single.out).at("results").at("fast");
    CHECK(columns["fast"][row] == answer.at("value"));
    CHECK(columns["fast_error"][row] == answer.at("error"));
    const double ref = std::stod(columns["ref"][row].get<std::string>());
    CHECK(std::fabs(ref - columns["fast"][row].get<double>()) <= columns["fast_error"][row].get<double>());
  }
  CHECK(std::stod(columns["eta"][0].get<std::string>()) == 0.1);
  CHECK(std::stod(columns["eta"][39].get<std::string>()) == 10);
}

TEST_CASE("a sweep's refused rows say why and make the status 1, and it is refused if all are") {
  const Outcome some = run("eval I1 alpha=-1..1:linear --points 3 --path fast");
  CHECK(some.status == 1);
  const std::vector<std::string> lines = csv_lines_of(some.out);
  REQUIRE(lines.size() == 4);
  CHECK(lines[0] == "alpha,fast,fast_error,missed,refused");
  CHECK(lines[1].ends_with(","));
  CHECK(lines[2] == "0,,,,alpha = 0: must be nonzero: the kernel is infinite there");
  const Outcome all = run("eval I1 alpha=0.0,0.0");
  CHECK(all.status == 2);
  CHECK(all.out.empty());
  CHECK(run("eval I1 alpha=1 --points 3").status == 2);
  CHECK(run("eval I1 alpha=1.0,2.0 eta=3").status == 2);
}

TEST_CASE("choices can be swept, and a seed's form") {
  const Outcome choices =
      run("eval ti.compliance axis=normal,in-plane theta_deg=30 psi_deg=0 speed=0.2 --path fast");
  CHECK(choices.status == 0);
  CHECK(csv_lines_of(choices.out).size() == 3);
  const Outcome printed = run("eval rolling.span_ratio poisson=0.3 speed=0.1,0.6 form=printed");
  CHECK(printed.status == 0);
  CHECK(csv_lines_of(printed.out).front() == "poisson,speed,printed,refused");
}

TEST_CASE("a sweep names in each row the paths that missed the accuracy, and its status is 1") {
  const std::string nip = "eval nip.load L_over_B=20 poisson=0.4999 friction=none,full --path fast ";
  const json columns = answer_to(nip + "rtol=2e-13", 1).at("columns");
  CHECK(columns["missed"] == json{nullptr, "fast"});
  for (const std::size_t row : {0U, 1U})
    CHECK((columns["fast_error"][row] > 2e-13 * columns["fast"][row].get<double>()) == (row == 1));
  CHECK(csv_lines_of(run(nip + "rtol=2e-13").out)[2].ends_with(",fast,"));
  const Outcome nothing_asked = run(nip + "--json");
  CHECK(nothing_asked.status == 0);
  CHECK(json::parse(nothing_asked.out)["columns"]["missed"] == json{nullptr, nullptr});
}
