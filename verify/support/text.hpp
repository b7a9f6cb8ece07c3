#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

/// The present number of columns of the descriptor's terminal; 80 if the descriptor is no terminal.
std::size_t columns_of(int descriptor);
/// The number of columns of standard output, at least 40.
std::size_t text_width();

/// The text in green, or in red, by escape sequences of terminals.
std::string good(std::string_view text);
std::string bad(std::string_view text);

/// The text without blanks at its ends.
std::string trimmed(std::string_view text);

/// The text with a blank in place of each control character.
std::string in_one_line(std::string text);

/// The words of a text, which white space separates.
std::vector<std::string> words_of(const std::string& text);

/// The parts of a text between separators. An empty part behind the last separator is left out.
std::vector<std::string> parts_of(std::string_view text, std::string_view separator);

/// The text without colours.
std::string plain(std::string_view text);

/// The number of columns that the text takes; escape sequences take none.
std::size_t width_of(std::string_view text);

/// Breaks each line that is too wide at spaces. Two spaces separate columns of a line. The continuation is indented to
/// the last column that begins in the first half of the width, or else by four more than the line. No word is broken.
std::string folded(std::string_view text, std::size_t width = text_width());

/// A table in plain text from lines with " | " between cells: each column is as wide as its widest cell, with two
/// spaces between columns. The first line has the heads; a '>' at the beginning of a head aligns its column at the
/// right and is not shown. A line indented by four is no row; it is folded. The text is empty if there are only heads.
std::string table_text(const std::vector<std::string>& lines);

}  // namespace nipref::verify
