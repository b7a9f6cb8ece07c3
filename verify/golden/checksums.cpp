#include <fmt/format.h>

#include <sstream>

#include <nipref/data/bad_input.hpp>
#include <nipref/data/input_file.hpp>
#include <nipref/verify/golden/checksums.hpp>

namespace nipref::verify {

Checksums Checksums::of(const std::filesystem::path& folder) {
  Checksums sums;
  const std::filesystem::path path = folder / checksums_name;
  if (!std::filesystem::exists(path)) return sums;
  std::istringstream lines(data::text_of_input_file(path, "checksums"));
  constexpr std::size_t digits = 64;
  for (std::string line; std::getline(lines, line);) {
    // The digest is followed by two blanks, or by a blank and a star for a file that was read as binary.
    const bool is_one = line.size() > digits + 2 && line[digits] == ' ' &&
                        line.find_first_not_of("0123456789abcdef") == digits;
    if (!is_one) throw data::BadInput("checksums", path.string(), "must have lines as sha256sum writes them");
    sums.by_name_[line.substr(digits + 2)] = line.substr(0, digits);
  }
  return sums;
}

std::string Checksums::text() const {
  std::string text;
  for (const auto& [name, digest] : by_name_) text += fmt::format("{}  {}\n", digest, name);
  return text;
}

}  // namespace nipref::verify
