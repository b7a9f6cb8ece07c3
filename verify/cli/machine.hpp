#pragma once
#include <string>

#include <nipref/verify/golden/make.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What this program was compiled with.
std::string compiler();

/// What golden values made now are made with.
Provenance provenance();

/// What this program was built from and with, and what it runs on: "nipref" in every answer.
Json version_json();

/// This program, whatever machine it runs on: what it was built from and with, the instruction set that fast uses, and
/// the SHA-256 of the program's file.
Json program_json();

}  // namespace nipref::verify
