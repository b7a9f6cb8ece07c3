#include <sys/wait.h>

#include <array>
#include <cstdio>

#include <nipref/verify/cli/output_of.hpp>

namespace nipref::verify {
namespace {

/// As one word of a shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "' ";
}

}  // namespace

ProgramOutput output_of(const std::vector<std::string>& words) {
  std::string command;
  for (const std::string& word : words) command += quoted(word);
  FILE* const pipe = popen((command + "2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return {-1, ""};
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), count);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

}  // namespace nipref::verify
