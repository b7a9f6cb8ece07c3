#pragma once
#include <string>
#include <string_view>

#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

// Answers for machines, all in the shape of data/schema/nipref-1.json: "schema", "nipref", what was answered, its
// members.

/// Of a verb that came to its end; with `no_times` there is no member "times" in it, at any depth; with
/// "interrupted": true if the process was, and it holds only what was finished by then.
std::string answer_text(std::string_view verb, const Json& members, bool no_times = false);

/// Of --version.
std::string version_answer_text();

/// Of what was refused or went wrong; `message` is the line on standard error. Parts that are not known are null.
std::string error_answer_text(std::string_view message, const Json& argument = {}, const Json& value = {},
                              const Json& allowed = {});

}  // namespace nipref::verify
