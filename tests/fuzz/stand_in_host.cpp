#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include <nipref/verify/grade/internal/protocol.hpp>

using nipref::verify::protocol::descriptor;

namespace {

/// False at the end.
bool read_all(void* data, std::size_t size) {
  for (char* next = static_cast<char*>(data); size > 0;) {
    const ssize_t count = read(descriptor, next, size);
    if (count <= 0) return false;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool read_request() {
  std::size_t size = 0;
  if (!read_all(&size, sizeof size)) return false;
  std::string request(size, '\0');
  return read_all(request.data(), size);
}

/// The first answer with its size; what is left if it is not as long as it says.
std::size_t first_length(const std::string& answers) {
  std::size_t size = 0;
  std::memcpy(&size, answers.data(), std::min(answers.size(), sizeof size));
  return size < answers.size() ? std::min(answers.size(), sizeof size + size) : answers.size();
}

}  // namespace

/// In the place of nipref-kernel-host: says what stands in the file, one answer first and one after each request,
/// and ends.
int main(int, char** arguments) {
  std::ostringstream text;
  text << std::ifstream(arguments[1], std::ios::binary).rdbuf();
  std::string answers = text.str();
  do {
    const std::size_t length = first_length(answers);
    if (write(descriptor, answers.data(), length) < 0) return 1;
    answers.erase(0, length);
  } while (!answers.empty() && read_request());
}
