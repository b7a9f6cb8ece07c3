#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace nipref::verify {

/// The columns of the terminal that a descriptor is now; 80 if it is none.
std::size_t columns_of(int descriptor);
/// Those of standard output, at least 40.
std::size_t text_width();

/// A text in green, or in red, by escape sequences of terminals.
std::string good(std::string_view text);
std::string bad(std::string_view text);

/// The text without blanks at its ends.
std::string trimmed(std::string_view text);

/// The text with a blank for each control character, whatever was in it.
std::string in_one_line(std::string text);

/// The words of a text, between white space.
std::vector<std::string> words_of(const std::string& text);

/// The parts of a text between separators; what is behind the last one counts unless it is empty.
std::vector<std::string> parts_of(std::string_view text, std::string_view separator);

/// The text without colours.
std::string plain(std::string_view text);

/// The number of columns that the text takes; escape sequences take none.
std::size_t width_of(std::string_view text);

/// Breaks each line that is too wide at spaces. The continuation starts below the last column of the line if that column is
/// in the first half, and otherwise four columns to the right of the line's start. A word that is too wide is not broken.
std::string folded(std::string_view text, std::size_t width = text_width());

/// A table in plain text, of lines with " | " between cells: each column is as wide as its widest cell, with two spaces
/// between columns. The first line has the heads; a head that begins with '>', which is not shown, makes its column flush
/// right. A line that is indented by four is no row, and is folded. Nothing if there are only heads.
std::string table_text(const std::vector<std::string>& lines);

}  // namespace nipref::verify
