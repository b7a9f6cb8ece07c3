#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <nipref/verify/cli/output_file.hpp>

namespace nipref::verify {

OutputError::OutputError(const std::string& place)
    : std::system_error(errno, std::generic_category(), place) {}

void write_output_file(const std::string& path, std::string_view text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw OutputError(path);
}

void replace_output_file(const std::string& path, std::string_view text) {
  std::error_code error;
  // Of a link the file that it stands for is replaced.
  std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  if (error) target = path;
  const std::filesystem::file_status there = std::filesystem::status(target, error);
  if (exists(there) && !is_regular_file(there)) return write_output_file(path, text);
  if (exists(there) && access(target.c_str(), W_OK) != 0) throw OutputError(path);
  const std::string beside = target.string() + ".part" + std::to_string(getpid());
  try {
    write_output_file(beside, text);
    if (exists(there)) std::filesystem::permissions(beside, there.permissions(), error);
    if (std::rename(beside.c_str(), target.c_str()) != 0) throw OutputError(path);
  } catch (const OutputError& reason) {
    std::filesystem::remove(beside, error);
    errno = reason.code().value();
    throw OutputError(path);
  }
}

}  // namespace nipref::verify
