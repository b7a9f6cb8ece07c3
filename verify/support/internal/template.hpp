#pragma once
#include <nlohmann/json_fwd.hpp>

#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The data from which a template is filled.
using TemplateData = nlohmann::ordered_json;

/// Escapes a text so that no part of it is read as markup.
using Escape = std::function<std::string(const std::string&)>;

/// Text of an element or an attribute of HTML. Control characters, which XML does not have, become spaces.
std::string escaped_for_html(std::string text);

/// The text of the file NAME in data/templates.
std::string template_text(const std::string& name);

/// Fills a template in the language Mustache. A section is left out for null, false and an empty list. An object has the
/// list `each` of its members, with `key` and `value`, if all of them are objects or lists, or none is. A section with
/// one of these names formats the number in it, or writes a dash if there is no number:
///   two_digits: "68000" for 68441; off: "26 % low" for -0.26; upward: an error with two digits, rounded upwards.
/// A section with one of these names formats the text in it:
///   as: a format specification of {fmt}, a space, and the number or text to format, as in ".3g 0.12345"; a % behind the
///   specification multiplies the number by 100;
///   decimal: hexadecimal numbers become decimals with six digits; exact: likewise, with the hexadecimal number behind;
///   mathml: HTML with its formulas in MathML, of text that is not escaped, see formula.hpp;
///   shell: a word of the shell; trimmed: without commas, semicolons and white space at the end;
///   good, bad: in the colour of a verdict on a terminal; table: in columns, see table_text.
/// Leaves out a name that the data does not have. Throws std::runtime_error if the text is not a template.
std::string filled(const std::string& text, const TemplateData& data, const Escape& escape);

/// Texts that a template includes by {{>NAME}}.
using Partials = std::map<std::string, std::string>;

/// Fills a template for plain text, which need not be escaped. Also throws std::runtime_error for a name that is missing.
std::string filled_text(const std::string& text, const TemplateData& data, const Partials& partials = {},
                        const Escape& escape = std::identity());
std::string filled_text(const std::string& text, const Json& data, const Partials& partials,
                        const Escape& escape);

}  // namespace nipref::verify
