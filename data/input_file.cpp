#include <unistd.h>

#include <cerrno>

#include <nipref/data/input_file.hpp>
#include <nipref/data/internal/common.hpp>

namespace nipref::data {
namespace {

[[noreturn]] void refuse_for_reason(const std::filesystem::path& path, std::string_view argument,
                                    int reason) {
  throw BadInput(argument, path.string(),
                 fmt::format("must be a file that can be read: {}", std::generic_category().message(reason)));
}

}  // namespace

void check_input_file(const std::filesystem::path& path, std::string_view argument) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    throw BadInput(argument, path.string(), "must be a file: this is a folder");
  if (access(path.c_str(), R_OK) == 0) return;
  if (errno == ENOENT || errno == ENOTDIR)
    throw BadInput(argument, path.string(), "must be a file that exists: there is none of that name");
  refuse_for_reason(path, argument, errno);
}

std::ifstream open_input_file(const std::filesystem::path& path, std::string_view argument) {
  check_input_file(path, argument);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_for_reason(path, argument, errno);
  return stream;
}

std::string text_of_input_file(const std::filesystem::path& path, std::string_view argument) {
  std::ifstream stream = open_input_file(path, argument);
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (stream.bad() || text.fail()) refuse_for_reason(path, argument, EIO);
  return text.str();
}

}  // namespace nipref::data
