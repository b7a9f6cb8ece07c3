#include <nipref/verify/catalogue/catalogue.hpp>
#include <nipref/verify/support/formula.hpp>

#include "support/test.hpp"

using nipref::verify::with_mathml;

TEST_CASE("formulas in a text are MathML, in which fractions, indices, powers and Greek letters are such") {
  const auto math = [](const std::string& content) { return "<math>" + content + "</math>"; };
  const struct {
    std::string formula, content;
  } cases[]{
      {"pi", "<mi>π</mi>"},
      {"theta1", "<msub><mi>θ</mi><mrow><mn>1</mn></mrow></msub>"},
      {"x^2", "<msup><mi>x</mi><mrow><mn>2</mn></mrow></msup>"},
      {"(x+ x)", "<mrow><mo>(</mo><msub><mi>x</mi><mrow><mo>+</mo></mrow></msub><mi>x</mi><mo>)</mo></mrow>"},
      {"e^(-a)", "<msup><mi>e</mi><mrow><mrow><mo>−</mo><mi>a</mi></mrow></mrow></msup>"},
      {"a b / (c d)",
       "<mfrac><mrow><mi>a</mi><mi>b</mi></mrow><mrow><mrow><mi>c</mi><mi>d</mi></mrow></mrow></mfrac>"},
      {"a/b", "<mi>a</mi><mo>/</mo><mi>b</mi>"},
      {"sqrt(2x)", "<msqrt><mrow><mn>2</mn><mi>x</mi></mrow></msqrt>"},
      {"1e-4", "<mrow><msup><mn>10</mn><mn>-4</mn></msup></mrow>"},
      {"int_0^inf x",
       "<msubsup><mo>∫</mo><mrow><mn>0</mn></mrow><mrow><mi>∞</mi></mrow></msubsup><mi>x</mi>"}};
  for (const auto& [formula, content] : cases) {
    CAPTURE(formula);
    CHECK(with_mathml("`" + formula + "`") == math(content));
  }
  CHECK(with_mathml("a < b: `x = y`!") ==
        "a &lt; b: " + math("<mi>x</mi>") + " " + math("<mo>=</mo><mi>y</mi>") + "!");
  CHECK(with_mathml("a ` b") == "a ` b");
}

TEST_CASE("a definition's marks come in pairs, and its text is the same without them") {
  for (const auto& quantity : nipref::verify::catalogue()) {
    CAPTURE(quantity.notation);
    CHECK(std::ranges::count(quantity.notation, '`') % 2 == 0);
    CHECK(nipref::verify::without_marks(quantity.notation) == quantity.definition);
    CHECK(quantity.definition.find('`') == std::string::npos);
  }
}
