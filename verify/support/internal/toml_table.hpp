#pragma once
#include <initializer_list>

#include <nipref/verify/support/internal/common.hpp>

namespace nipref::verify {

/// A table of a TOML file. BadInput names the line for anything that is missing or not allowed.
struct TomlTable {
  std::string what;   ///< the kind of file, as BadInput names it: "statements file"
  std::string where;  ///< FILE:LINE
  std::map<std::string, std::string> texts = {};
  std::map<std::string, double> numbers = {};                  ///< `true` is 1, `false` is 0
  std::map<std::string, std::vector<std::string>> words = {};  ///< lists of texts
  std::map<std::string, std::vector<TomlTable>> tables =
      {};                              ///< lists of tables; a single table is a list of one
  std::vector<std::string> keys = {};  ///< the keys of all these

  // The value of the key; BadInput if it is missing or of another type.
  [[nodiscard]] const std::string& text(const std::string& key) const;
  [[nodiscard]] double number(const std::string& key) const;
  [[nodiscard]] const TomlTable& table(const std::string& key) const;
  // The value of the key, or this default if the key is missing. The default of words and texts is empty.
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double number_or(const std::string& key, double otherwise) const;
  [[nodiscard]] std::vector<std::string> words_of(const std::string& key) const;
  [[nodiscard]] std::map<std::string, std::string> texts_of(const std::string& key) const;  ///< of a table
  /// A list of tables. BadInput for the first table that has another key or lacks a required text.
  [[nodiscard]] const std::vector<TomlTable>& list(const std::string& key,
                                                   std::initializer_list<std::string_view> required,
                                                   std::initializer_list<std::string_view> optional) const;
  /// The table with this `id` in a list; BadInput if there is none.
  [[nodiscard]] const TomlTable& entry(const std::string& key, const std::string& id) const;
  [[noreturn]] void refuse(std::string_view requirement) const;
  /// Calls f() and throws its BadInput again with the line in front.
  auto located(const auto& f) const {
    try {
      return f();
    } catch (const data::BadInput& bad) {
      refuse(bad.what());
    }
  }
};

/// Reads a text of TOML. BadInput says what is wrong and where.
[[nodiscard]] TomlTable parse_toml(const std::string& text, const std::string& what, const std::string& path);
/// Reads a TOML file.
[[nodiscard]] TomlTable read_toml(const std::filesystem::path& path, const std::string& what);
/// A file of data/statements. Each file is read once.
[[nodiscard]] const TomlTable& statements_file(const std::string& name);

}  // namespace nipref::verify
