#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace nipref::verify {

/// What to pin: the SHA-256 of SHA256SUMS, and so of all golden values; empty if there is none.
std::string golden_version();

/// A golden file of any kind as csv, json, cpp or npy, for programs that do not read the CSV. Numbers are the doubles
/// nearest to the texts, bounds those above. BadInput as read_csv has it.
std::string exported_golden(const std::filesystem::path& path, std::string_view format);

}  // namespace nipref::verify
