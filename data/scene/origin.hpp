#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <nipref/data/bad_input.hpp>

namespace nipref::data {

/// The lines of a scene's keys in the file that it was read from, so that every later refusal can name the place. It is
/// empty for a scene made in C++. Keys are written "roller.radius", elements of a list "wanted[1]" (counted from 0). A
/// refusal shows keys that were given beside the file, and their values, as they were given there.
class SceneOrigin {
 public:
  SceneOrigin() = default;
  explicit SceneOrigin(std::string file) : file_(std::move(file)) {}

  /// Notes the line of a key, counted from 1. Line 0 means that the key is not in the file, and is ignored.
  void note(std::string key, std::size_t line) {
    if (line > 0) lines_.insert_or_assign(std::move(key), line);
  }
  /// Notes that this key was given beside the file, as this text, in place of the value that the file has there.
  void note_given(std::string key, std::string value) {
    given_.insert_or_assign(std::move(key), std::move(value));
  }

  /// "FILE:LINE: KEY", where the line is that of the innermost noted part of the key; "FILE: KEY" if no part is noted;
  /// "KEY" if there is no file, or if that part was given beside it.
  [[nodiscard]] std::string locate(std::string_view key) const;

  /// Throws BadInput with locate(key) as its argument.
  [[noreturn]] void refuse(std::string_view key, std::string_view value, std::string_view allowed) const;
  [[noreturn]] void refuse(std::string_view key, double value, std::string_view allowed) const;

  /// Throws `error` again with locate(key) in place of the argument that it names.
  [[noreturn]] void refuse_as(std::string_view key, const BadInput& error) const;

  /// Refuses the value unless `holds`; require_whole() unless it is from `least` to `most`.
  void require(bool holds, std::string_view key, double value, std::string_view allowed) const;
  void require_whole(std::string_view key, int value, int least, int most) const;
  /// Refuses a number that is not in the domain that scene_keys() has for the key, and each such number of a list.
  void check_domain(std::string_view key, double value) const;
  void check_domain(std::string_view key, const std::vector<double>& list) const;

 private:
  std::string file_;
  std::map<std::string, std::size_t, std::less<>> lines_;
  std::map<std::string, std::string, std::less<>> given_;
};

}  // namespace nipref::data
