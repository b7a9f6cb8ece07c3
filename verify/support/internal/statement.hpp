#pragma once
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

#include <nipref/data/bad_input.hpp>

namespace nipref::verify {

/// A table of a TOML file in data/statements.
struct Statement {
  std::string where;  ///< FILE:LINE
  std::map<std::string, std::string> texts = {};
  std::map<std::string, double> numbers = {};
  std::map<std::string, std::vector<Statement>> lists = {};

  // The value of the key; they throw BadInput that names the line if it is missing or of another type.
  [[nodiscard]] const std::string& text(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double number_or(const std::string& key, double otherwise) const;
  /// A list of tables. Throws BadInput that names the line of the first entry that has another key or lacks a required text.
  [[nodiscard]] const std::vector<Statement>& list(const std::string& key,
                                                   std::initializer_list<std::string_view> required,
                                                   std::initializer_list<std::string_view> optional) const;
  /// The entry of a list with that `id`; throws BadInput if there is none.
  [[nodiscard]] const Statement& entry(const std::string& key, const std::string& id) const;
  [[noreturn]] void refuse(std::string_view requirement) const;
  /// f(), whose BadInput is thrown again with the line in front.
  auto located(const auto& f) const {
    try {
      return f();
    } catch (const data::BadInput& bad) {
      refuse(bad.what());
    }
  }
};

/// Reads a file of data/statements; throws BadInput that names the line if it cannot be read.
[[nodiscard]] Statement read_statements(const std::filesystem::path& path);

}  // namespace nipref::verify
