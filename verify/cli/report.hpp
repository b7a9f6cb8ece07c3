#pragma once
#include <nipref/verify/report/report.hpp>
#include <nipref/verify/support/json.hpp>

namespace nipref::verify {

/// What `report` answers: what its parts would.
Json report_json(const Report& report);

}  // namespace nipref::verify
