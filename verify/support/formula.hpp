#pragma once
#include <string>

namespace nipref::verify {

// A text has its formulas between backticks, in a notation for both the terminal's text and the page's MathML: "by a
// load: `int_0^inf sin(alpha x) / x dx`". a_b and a^b are indices, with or without brackets about b. ` / ` with blanks
// is a fraction bar: the product before it is the numerator, the factor behind it the denominator; / without blanks is
// a slant. int_a^b is an integral, sqrt(a) a root, * a convolution. Names of Greek letters and inf are those signs.
// Digits behind a name, or a sign at its end, are its index. d with a letter is a differential, a longer name upright.

/// The text without backticks.
std::string without_marks(std::string text);

/// The text, escaped for HTML, with its formulas in MathML. A backtick without a second one stands for itself. Lines of
/// a formula may be broken before a term of a sum or a side of a comparison.
std::string with_mathml(const std::string& text);

}  // namespace nipref::verify
