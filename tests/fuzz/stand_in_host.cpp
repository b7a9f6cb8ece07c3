#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include <nipref/verify/grade/internal/exchange.hpp>

using nipref::verify::protocol::connection;
using nipref::verify::protocol::Exchange;

/// Takes the place of nipref-kernel-host: answers each request with the content of the file.
int main(int, char** arguments) {
  std::ostringstream text;
  text << std::ifstream(arguments[1], std::ios::binary).rdbuf();
  const std::string answer = text.str();
  void* const memory = mmap(nullptr, sizeof(Exchange), PROT_READ | PROT_WRITE, MAP_SHARED, STDIN_FILENO, 0);
  if (memory == MAP_FAILED) return 1;
  std::uint64_t request = 0;
  while (recv(connection, &request, sizeof request, 0) == sizeof request) {
    std::memcpy(memory, answer.data(), std::min(answer.size(), sizeof(Exchange)));
    if (send(connection, &request, sizeof request, MSG_NOSIGNAL) == -1) return 1;
  }
}
