#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <nipref/verify/support/sha256.hpp>

namespace nipref::verify {

/// The SHA256SUMS of a folder, in the format of sha256sum.
class Checksums {
 public:
  /// Reads the file; empty if the folder has none. BadInput if it has another format.
  static Checksums of(const std::filesystem::path& folder);

  [[nodiscard]] const std::map<std::string, std::string>& by_name() const { return by_name_; }
  void set(const std::string& name, std::string_view bytes) { by_name_[name] = sha256(bytes); }
  [[nodiscard]] std::string text() const;

 private:
  std::map<std::string, std::string> by_name_;
};

inline constexpr auto checksums_name = "SHA256SUMS";

}  // namespace nipref::verify
