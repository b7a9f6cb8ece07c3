#include <cerrno>
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

}  // namespace nipref::verify
