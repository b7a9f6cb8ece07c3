#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

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
///   g, g2, g3, g4: that many significant digits; e1; percent and percent2: digits; signed: a percentage with its sign;
///   two_digits: "68000" of 68441; off: "26 % low" of -0.26.
/// With one of these it formats text:
///   decimal: hexadecimal numbers in it with six digits; shell: as a word of the shell; good, bad: in the colour of a verdict
///   on a terminal.
/// Throws std::runtime_error if the text is not a template.
std::string filled(const std::string& text, const TemplateData& data, const Escape& escape);

}  // namespace nipref::verify
