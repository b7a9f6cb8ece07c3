#include <nlohmann/json.hpp>

#include <nipref/verify/support/internal/print_json.hpp>

namespace nipref::verify {

void print_json(const nlohmann::ordered_json& json, std::ostream& out) { out << json.dump(2) << '\n'; }

}  // namespace nipref::verify
