#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include <nipref/verify/support/internal/process.hpp>

namespace nipref::verify {
namespace {

void throw_error(int error, const std::string& what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

std::string content_of(const Descriptor& file) {
  std::string text(static_cast<std::size_t>(lseek(file.number(), 0, SEEK_END)), '\0');
  const ssize_t size = pread(file.number(), text.data(), text.size(), 0);
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return text;
}

}  // namespace

Descriptor::Descriptor(int number) : number_(number) {
  throw_error(number == -1 ? errno : 0, "file descriptor");
}
Descriptor::~Descriptor() { close(number_); }

int file_in_memory(int flags) {
  const int file = memfd_create("nipref", MFD_CLOEXEC);
  return file != -1 && fcntl(file, F_SETFL, flags) == -1 ? -1 : file;
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written == -1 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

pid_t started(std::vector<std::string> words, const std::vector<int>& descriptors, bool apart) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
  sigset_t none;
  sigemptyset(&none);
  throw_error(posix_spawn_file_actions_init(&actions), words.front());
  throw_error(posix_spawnattr_init(&attributes), words.front());
  posix_spawnattr_setflags(&attributes,
                           static_cast<short>(POSIX_SPAWN_SETSIGMASK | (apart ? POSIX_SPAWN_SETPGROUP : 0)));
  posix_spawnattr_setsigmask(&attributes, &none);
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    posix_spawn_file_actions_adddup2(&actions, descriptors[i], static_cast<int>(i));
  pid_t process = -1;
  const int error = posix_spawnp(&process, pointers[0], &actions, &attributes, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  throw_error(error, words.front());
  return process;
}

int status_at_end(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) == -1 && errno == EINTR) continue;
  return status;
}

ProgramOutput output_of(const std::vector<std::string>& words, std::string_view input) {
  const Descriptor in(file_in_memory()), out(file_in_memory()),
      error(open("/dev/null", O_WRONLY | O_CLOEXEC));
  throw_error(write_all(in.number(), input) && lseek(in.number(), 0, SEEK_SET) == 0 ? 0 : errno, "input");
  try {
    const int status = status_at_end(started(words, {in.number(), out.number(), error.number()}));
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out)};
  } catch (const std::system_error&) {
    return {status_not_found, ""};
  }
}

}  // namespace nipref::verify
