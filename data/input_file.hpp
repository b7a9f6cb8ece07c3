#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace nipref::data {

/// Throws BadInput "ARGUMENT = PATH: ALLOWED" if the file does not exist, is a folder, or may not be read; each case
/// has its own message. The file is not opened, because a pipe can be read only once.
void check_input_file(const std::filesystem::path& path, std::string_view argument);

/// Opens the file for reading. Throws BadInput as check_input_file does.
[[nodiscard]] std::ifstream open_input_file(const std::filesystem::path& path, std::string_view argument);

/// Returns every byte of the file. Throws BadInput as check_input_file does.
[[nodiscard]] std::string text_of_input_file(const std::filesystem::path& path, std::string_view argument);

}  // namespace nipref::data
