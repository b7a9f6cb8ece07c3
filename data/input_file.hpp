#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace nipref::data {

/// BadInput "ARGUMENT = PATH: ALLOWED" for what cannot be read: nothing of that name, a folder, or a file that may not
/// be read, each in words of its own. Opens nothing: what a pipe holds can be read once only.
void check_input_file(const std::filesystem::path& path, std::string_view argument);

/// The file, open to be read, or what check_input_file says.
[[nodiscard]] std::ifstream open_input_file(const std::filesystem::path& path, std::string_view argument);

/// Every byte of it.
[[nodiscard]] std::string text_of_input_file(const std::filesystem::path& path, std::string_view argument);

}  // namespace nipref::data
