#pragma once
#include <optional>
#include <string>

namespace nipref::verify {

/// What gnuplot's script draws, as SVG; nothing where gnuplot is not installed. Throws std::runtime_error where it fails.
std::optional<std::string> drawn_by_gnuplot(const std::string& script);

}  // namespace nipref::verify
