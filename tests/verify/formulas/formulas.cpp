#include <nipref/verify/seeds/internal/solved.hpp>

#include "support/scratch.hpp"

using namespace nipref;

namespace {

double value(const std::string& formula, const std::string& given = "") {
  verify::Formulas formulas(verify::SolvedNumbers{});
  formulas.define(given);
  return formulas.value(formula).value();
}

}  // namespace

TEST_CASE("formulas of statements follow the rules of arithmetic") {
  CHECK(value("1 - 2 - 3*4/8") == -2.5);
  CHECK(value("-2^2 + (1 + 2)*3") == 5);
  CHECK(value("f(3) + t", "t = 2\nf(t) = t*t") == 11);
  CHECK(value("if(1 < 2, 5, log(-1)) + min(3, 1, 2) - max(4, 7)") == -1);
  CHECK(value("certain(1 + within(0.5)) - certain(1 + within(2))") == 1);
  CHECK(value("integral(t, 0, 1, t^2)") == doctest::Approx(1.0 / 3));
  CHECK(value("largest(t, 0, 3, t*(2 - t)) + sign_change(t, 0, 2, 1 - t)") == doctest::Approx(2));
  // Both paths of the catalogue. I1 is even.
  CHECK(value("[ref I1 alpha=0.5] - [fast I1 alpha=$a]", "a = -0.5") == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("what a statement lacks is said with the file and the line") {
  const ScratchFile file("# a comment\n[[limit]]\nname = \"a\"\nfound = \"1 + unknown\"\norder = \"two\"\n");
  const verify::TomlTable all = verify::read_toml(file.path(), "statements file");
  const verify::TomlTable& limit = all.tables.at("limit").front();
  const std::string where = "statements file = " + file.path() + ":2: ";
  CHECK_REFUSED(limit.number("order"), where + "must have a number as order");
  CHECK_REFUSED(all.list("limit", {"name"}, {"found"}),
                where + "must have no keys in [[limit]] but name, found");
  verify::StatementFormulas formulas(all, limit);
  CHECK_REFUSED(formulas.value(limit.text("found")),
                where + "formula = unknown: must be the name of a number that is defined before");
  for (const char* formula :
       {"1 +", "(1", "f(1)", "2^0.5", "if(1, 2)", "[none a b=1]", "[elastic weight]", "1 2"}) {
    CAPTURE(formula);
    CHECK_THROWS_AS(static_cast<void>(formulas.value(formula)), data::BadInput);
  }
}
