#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <nipref/verify/grade/junit.hpp>

#include "support/test.hpp"

using namespace nipref::verify;
using Outcome = JUnitCase::Outcome;

TEST_CASE("JUnit's counts are those of its cases, and each says what became of it") {
  std::istringstream text(junit_text("nipref grade", {{"a", 1e-9, Outcome::passed, "", "all well"},
                                                      {"b <&\"'>\x01", 2, Outcome::failed, "4 > 2", "more"},
                                                      {"c", 3.5, Outcome::error, "crash", ""}}));
  boost::property_tree::ptree root;
  read_xml(text, root);
  const auto& suite = root.get_child("testsuites.testsuite");
  CHECK(suite.get<int>("<xmlattr>.tests") == 3);
  for (const char* const count : {"failures", "errors"})
    CHECK(suite.get<int>(std::string("<xmlattr>.") + count) == 1);
  CHECK(suite.get<std::string>("<xmlattr>.time") == "5.500000");
  std::vector<boost::property_tree::ptree> cases;
  for (const auto& [name, one] : suite) {
    if (name == "testcase") cases.push_back(one);
  }
  REQUIRE(cases.size() == 3);
  CHECK(cases[0].get<std::string>("<xmlattr>.time") == "0.000000");  // no exponent
  CHECK(cases[0].get<std::string>("system-out") == "all well");
  CHECK(cases[0].count("failure") + cases[0].count("error") == 0);
  CHECK(cases[1].get<std::string>("<xmlattr>.name") == "b <&\"'>");
  CHECK(cases[1].get<std::string>("failure.<xmlattr>.message") == "4 > 2");
  CHECK(cases[2].get<std::string>("error.<xmlattr>.message") == "crash");
}
