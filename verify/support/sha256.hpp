#pragma once
#include <string>
#include <string_view>

namespace nipref::verify {

/// The SHA-256 checksum of these bytes, in 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace nipref::verify
