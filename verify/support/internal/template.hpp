#pragma once
#include <nlohmann/json_fwd.hpp>

#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// The data from which a template is filled.
using TemplateData = nlohmann::ordered_json;

/// Escapes a text, so that no part of it is read as markup.
using Escape = std::function<std::string(const std::string&)>;

/// Text of an element or an attribute of HTML. Control characters, which XML does not have, become spaces.
std::string escaped_for_html(std::string text);

/// The text of the file NAME in data/templates.
std::string template_text(const std::string& name);

/// Fills a template in the language Mustache. A section is left out for null, false and an empty list. An object whose
/// members are all objects, or none of which is an object or a list, also has the list `each` of its members: `key` and
/// `value`. A section with one of these names formats the number in it, and writes a dash where there is none:
///   two_digits: "68000" of 68441; off: "26 % low" of -0.26; upward: an error with two digits, rounded upwards.
/// With one of these it formats text:
///   as: the number or the text behind a format specification of {fmt} and a space, as in ".3g 0.12345"; with % behind the
///   specification the number is multiplied by 100;
///   decimal: hexadecimal numbers in it with six digits; exact: so with the hexadecimal number in brackets behind;
///   mathml: HTML with its formulas in MathML, of text that is not escaped, see formula.hpp;
///   shell: as a word of the shell; trimmed: without commas, semicolons and white space at its end; good, bad: in the colour of a verdict
///   on a terminal; table: in columns, of lines with " | " between cells: the first has the heads, see table_text,
///   one that is indented by four stands below the row before it.
/// Throws std::runtime_error if the text is not a template. A name that the data does not have is left out.
std::string filled(const std::string& text, const TemplateData& data, const Escape& escape);

/// Texts that a template puts in by {{>NAME}}.
using Partials = std::map<std::string, std::string>;

/// The same for text, which need not be escaped. Throws std::runtime_error for a name that the data does not have, too.
std::string filled_text(const std::string& text, const TemplateData& data, const Partials& partials = {},
                        const Escape& escape = std::identity());
std::string filled_text(const std::string& text, const Json& data, const Partials& partials,
                        const Escape& escape);

}  // namespace nipref::verify
