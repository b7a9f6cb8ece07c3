#pragma once
#include <string>
#include <string_view>

namespace nipref::verify {

/// SHA-256 of these bytes, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace nipref::verify
