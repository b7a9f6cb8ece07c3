#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <nipref/verify/cli/output.hpp>
#include <nipref/verify/cli/programs.hpp>

namespace nipref::verify {

namespace {

/// As one word of a shell.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "' ";
}

using File = std::unique_ptr<FILE, int (*)(FILE*)>;

/// A file without a name that holds the text.
File file_with(std::string_view text) {
  File file(std::tmpfile(), std::fclose);
  const auto written = [&] {
    return text.empty() || std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  };
  if (file == nullptr || !written() || std::fflush(file.get()) != 0) throw OutputError("temporary file");
  return file;
}

/// By which another process opens it.
std::string name_of(const File& file) {
  return "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(fileno(file.get()));
}

}  // namespace

ProgramOutput output_of(const std::vector<std::string>& words, std::string_view input) {
  const File file = file_with(input);
  std::string command;
  for (const std::string& word : words) command += quoted(word);
  FILE* const pipe = popen((command + "<" + name_of(file) + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return {-1, ""};
  std::string text;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    text.append(buffer.data(), count);
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

std::optional<std::string> drawn_by_gnuplot(const std::string& script) {
  // Whatever the user has set up; by that name a script ends with its first error.
  const ProgramOutput drawn = output_of({"gnuplot", "-d", "/dev/stdin"}, script);
  if (drawn.status == status_not_found) return std::nullopt;
  if (drawn.status != 0) throw std::runtime_error("gnuplot does not draw: " + script.substr(0, 1000));
  return drawn.text;
}

}  // namespace nipref::verify
