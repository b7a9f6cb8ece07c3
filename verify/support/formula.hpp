#pragma once
#include <string>

namespace nipref::verify {

// Texts have their formulas between backticks, in one notation from which the text of a terminal and the page's MathML are
// made: "by a load: `int_0^inf sin(alpha x) / x dx`". In it a_b and a^b are indices, a factor in brackets or without; ` / `
// with blanks is the bar of a fraction of two products, of a denominator of one factor, and / without blanks a slant;
// int_a^b is an integral, sqrt(a) a root. Names of Greek letters and inf are those signs; digits behind a name, or a sign at
// its end, are its index; d with any letter is a differential; names of several letters are upright. * is a convolution.

/// The text without backticks.
std::string without_marks(std::string text);

/// The text, escaped for HTML, with its formulas in MathML. A backtick without its other is itself. A formula may be broken
/// in lines before what is added or compared.
std::string with_mathml(const std::string& text);

}  // namespace nipref::verify
