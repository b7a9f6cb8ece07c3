#pragma once
#include <string>
#include <string_view>
#include <system_error>

namespace nipref::verify {

/// What was asked for could not be written; the system's reason.
class OutputError : public std::system_error {
 public:
  /// `place` is a file's path, or standard output; the reason is that of the last system call.
  explicit OutputError(const std::string& place);
};

/// Replaces what is in the file. OutputError if any of it could not be written.
void write_output_file(const std::string& path, std::string_view text);

/// The same, so that whatever happens the file is the old one or the new one: the text is written beside it and takes
/// its name. What is no regular file, a pipe or a device, is written to.
void replace_output_file(const std::string& path, std::string_view text);

}  // namespace nipref::verify
