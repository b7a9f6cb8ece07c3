#include <nlohmann/json.hpp>

#include "support/run_nipref.hpp"
#include "support/test.hpp"

using nlohmann::json;

TEST_CASE("a sweep's row is what eval says at its arguments, and rows come in the order of their arguments") {
  const json columns =
      answer_to("eval I6 alpha=0x1p-3,7.5 eta=0.1..10:log --points 40 --digits 20").at("columns");
  REQUIRE(columns.at("alpha").size() == 80);
  for (const std::size_t row : {0U, 17U, 39U, 40U, 79U}) {
    CAPTURE(row);
    CHECK(columns["alpha"][row] == (row < 40 ? "0x1p-3" : "7.5"));
    const json answer = answer_to("eval I6 alpha=" + columns["alpha"][row].get<std::string>() + " eta=" +
                                  columns["eta"][row].get<std::string>() + " --path fast")["results"]["fast"];
    CHECK(columns["fast"][row] == answer.at("value"));
    CHECK(columns["fast_error"][row] == answer.at("error"));
    const double ref = std::stod(columns["ref"][row].get<std::string>());
    CHECK(std::fabs(ref - columns["fast"][row].get<double>()) <= columns["fast_error"][row].get<double>());
  }
  CHECK(std::stod(columns["eta"][0].get<std::string>()) == 0.1);
  CHECK(std::stod(columns["eta"][39].get<std::string>()) == 10);
}
