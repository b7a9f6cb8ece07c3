#pragma once
#include <nlohmann/json_fwd.hpp>
#include <ostream>

namespace nipref::verify {

/// As every verb prints it, with a line break at the end. (In one place, as the serializer is slow to
/// compile.)
void print_json(const nlohmann::ordered_json& json, std::ostream& out);

}  // namespace nipref::verify
