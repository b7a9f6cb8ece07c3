#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <numeric>
#include <sstream>

#include <nipref/verify/grade/junit.hpp>

namespace nipref::verify {
namespace {

using boost::property_tree::ptree;
/// Times are read as xs:decimal, which has no exponents.
std::string seconds_text(double seconds) { return fmt::format("{:.6f}", seconds); }

/// XML 1.0 cannot hold control characters, not even escaped.
std::string printable(std::string text) {
  std::erase_if(text, [](unsigned char letter) { return letter < ' ' && letter != '\n' && letter != '\t'; });
  return text;
}

const char* element_of(JUnitCase::Outcome outcome) {
  return outcome == JUnitCase::Outcome::failed ? "failure" : "error";
}

ptree tree_of(const std::string& suite, const JUnitCase& one) {
  ptree tree;
  tree.put("<xmlattr>.classname", printable(suite));
  tree.put("<xmlattr>.name", printable(one.name));
  tree.put("<xmlattr>.time", seconds_text(one.seconds));
  if (one.outcome != JUnitCase::Outcome::passed) {
    ptree result;
    result.put("<xmlattr>.message", printable(one.message));
    result.put("<xmlattr>.type", element_of(one.outcome));
    tree.add_child(element_of(one.outcome), result);
  }
  if (!one.details.empty()) tree.add("system-out", printable(one.details));
  return tree;
}

}  // namespace

std::string junit_text(const std::string& suite, const std::vector<JUnitCase>& cases) {
  const auto count = [&](JUnitCase::Outcome outcome) {
    return std::ranges::count(cases, outcome, &JUnitCase::outcome);
  };
  const double seconds = std::accumulate(cases.begin(), cases.end(), 0.0,
                                         [](double sum, const JUnitCase& one) { return sum + one.seconds; });
  ptree tests;
  tests.put("<xmlattr>.name", printable(suite));
  tests.put("<xmlattr>.tests", cases.size());
  tests.put("<xmlattr>.failures", count(JUnitCase::Outcome::failed));
  tests.put("<xmlattr>.errors", count(JUnitCase::Outcome::error));
  tests.put("<xmlattr>.time", seconds_text(seconds));
  for (const JUnitCase& one : cases) tests.add_child("testcase", tree_of(suite, one));
  ptree root;
  root.add_child("testsuites.testsuite", tests);
  std::ostringstream text;
  write_xml(text, root, boost::property_tree::xml_writer_make_settings<std::string>(' ', 2));
  return text.str();
}

}  // namespace nipref::verify
