#include "verify/print_json.hpp"

#include <nlohmann/json.hpp>

namespace nipref::verify {

void print_json(const nlohmann::ordered_json& json, std::ostream& out) { out << json.dump(2) << '\n'; }

}  // namespace nipref::verify
