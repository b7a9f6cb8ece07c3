#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace nipref::verify {

/// What people read is this wide.
inline constexpr std::size_t text_width = 80;

/// A verdict in the colour of what is well, and of what is not, as a terminal shows it.
std::string good(std::string_view text);
std::string bad(std::string_view text);
inline std::string verdict(bool well, std::string_view text) { return well ? good(text) : bad(text); }

/// Without colours.
std::string plain(std::string_view text);

/// Columns that the text takes: colours take none.
std::size_t width_of(std::string_view text);

/// Each line that is too wide broken at spaces. It goes on below its last column, where that starts in the first half,
/// or else a little to the right of where it starts. A word that is too wide by itself stays whole.
std::string folded(std::string_view text);

}  // namespace nipref::verify
