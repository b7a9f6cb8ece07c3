#pragma once
#include <ostream>

#include <nipref/verify/cli/command_line.hpp>

namespace nipref::verify {

// The verbs of the command line. Each writes its result to `out` and returns the exit status: 0 all well, 1 a
// check fell short. Bad input is thrown as BadInput before anything is written.

int list_verb(const CommandLine& line, std::ostream& out);
int eval_verb(const CommandLine& line, std::ostream& out);
int solve_verb(const CommandLine& line, std::ostream& out);
int balance_verb(const CommandLine& line, std::ostream& out);
int audit_verb(const CommandLine& line, std::ostream& out);
int merge_verb(const CommandLine& line, std::ostream& out);
int points_verb(const CommandLine& line, std::ostream& out);
int grade_verb(const CommandLine& line, std::ostream& out);
int golden_verb(const CommandLine& line, std::ostream& out);
int limits_verb(const CommandLine& line, std::ostream& out);
int claims_verb(const CommandLine& line, std::ostream& out);
int errata_verb(const CommandLine& line, std::ostream& out);
int figures_verb(const CommandLine& line, std::ostream& out);
int bench_verb(const CommandLine& line, std::ostream& out);
int tables_verb(const CommandLine& line, std::ostream& out);
int report_verb(const CommandLine& line, std::ostream& out);

}  // namespace nipref::verify
