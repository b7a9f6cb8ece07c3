#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <thread>

#include <nipref/data/bad_input.hpp>
#include <nipref/verify/grade/internal/child.hpp>

namespace nipref::verify {
namespace {

namespace fs = std::filesystem;
using protocol::Message;
using protocol::Request;

constexpr auto host_variable = "NIPREF_KERNEL_HOST";
/// The host's answers are not longer; a longer one was written by the plugin.
constexpr std::size_t longest_answer = 16 << 20;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

void check(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// A new file in memory, opened for appending.
int scratch_file(const char* name) {
  const int file = memfd_create(name, MFD_CLOEXEC);
  if (file == -1 || fcntl(file, F_SETFL, O_APPEND) == -1) fail("memfd_create");
  return file;
}

class FileActions {
 public:
  FileActions() { check(posix_spawn_file_actions_init(&actions_), "posix_spawn"); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  void duplicate(int from, int to) {
    check(posix_spawn_file_actions_adddup2(&actions_, from, to), "posix_spawn");
  }
  void open_nothing(int to) {
    check(posix_spawn_file_actions_addopen(&actions_, to, "/dev/null", O_RDONLY, 0), "posix_spawn");
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// The process gets a process group of its own, so that Ctrl-C in a terminal interrupts this program only.
class Attributes {
 public:
  Attributes() {
    check(posix_spawnattr_init(&attributes_), "posix_spawn");
    check(posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK),
          "posix_spawn");
    sigset_t none;
    sigemptyset(&none);
    check(posix_spawnattr_setsigmask(&attributes_, &none), "posix_spawn");
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

std::string signal_text(int signal) {
  const char* const name = sigabbrev_np(signal);
  return name == nullptr ? fmt::format("signal {}", signal)
                         : fmt::format("SIG{} ({})", name, sigdescr_np(signal));
}

/// The folder of the running program; empty if it is unknown.
fs::path program_folder() {
  std::error_code unknown;
  return fs::read_symlink("/proc/self/exe", unknown).parent_path();
}

bool can_run(const fs::path& file) { return access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file); }

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

fs::path kernel_host() {
  if (const char* const chosen = std::getenv(host_variable)) {
    if (can_run(chosen)) return chosen;
    throw data::BadInput(host_variable, chosen, "must be the program nipref-kernel-host");
  }
  for (const fs::path& folder : {program_folder() / NIPREF_HOST_FROM_PROGRAM, fs::path(NIPREF_HOST_INSTALLED),
                                 fs::path(NIPREF_HOST_BUILT)}) {
    if (can_run(folder / "nipref-kernel-host")) return folder / "nipref-kernel-host";
  }
  throw data::BadInput(
      host_variable, "(not set)",
      "must be the program nipref-kernel-host, which was not found beside this program nor where it "
      "was installed");
}

Child::Child(const HostOrders& orders)
    : time_limit_(orders.time_limit),
      output_(scratch_file("standard output")),
      error_(scratch_file("standard error")) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == -1) fail("socketpair");
  const Descriptor its_end(ends[1]);
  socket_ = ends[0];
  FileActions actions;
  actions.open_nothing(STDIN_FILENO);
  actions.duplicate(output_.number(), STDOUT_FILENO);
  actions.duplicate(error_.number(), STDERR_FILENO);
  actions.duplicate(its_end.number(), protocol::descriptor);
  std::array<std::string, 6> words{kernel_host().string(),
                                   fs::absolute(orders.file).string(),
                                   orders.symbol,
                                   fmt::format("{}", orders.arity),
                                   fmt::format("{}", orders.flags),
                                   fmt::format("{}", orders.time_limit)};
  std::array<char*, words.size() + 1> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  const Attributes attributes;
  if (const int error =
          posix_spawn(&process_, arguments[0], actions.get(), attributes.get(), arguments.data(), environ)) {
    close(socket_);
    check(error, "posix_spawn");
  }
}

Child::~Child() {
  close(socket_);
  if (process_ == -1) return;
  ::kill(process_, SIGKILL);
  wait();
}

Child::Answer Child::greeting() { return receive(std::max(time_limit_, protocol::seconds_to_begin)); }

Child::Answer Child::ask(const Message& request) {
  if (!send(request)) return death();
  const auto kind = Message(request).take<Request>();
  const bool begins = kind == Request::open || kind == Request::close;
  return receive(begins ? std::max(time_limit_, protocol::seconds_to_begin) : time_limit_);
}

Child::Answer Child::receive(double time_limit) {
  const Instant deadline =
      std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                             std::chrono::duration<double>(time_limit));
  const auto end = [&](Received how) {
    return how == Received::late ? kill(FaultKind::hang, fmt::format("no answer within {} s", time_limit))
                                 : death();
  };
  std::size_t size = 0;
  if (const Received how = receive(&size, sizeof size, deadline); how != Received::all) return end(how);
  if (size > longest_answer) return kill(FaultKind::protocol, "wrote to a descriptor that is not its own");
  std::vector<char> bytes(size);
  if (const Received how = receive(bytes.data(), size, deadline); how != Received::all) return end(how);
  return Message(std::move(bytes));
}

Child::Received Child::receive(void* data, std::size_t size, Instant deadline) const {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    const double left =
        std::chrono::duration<double, std::milli>(deadline - std::chrono::steady_clock::now()).count();
    if (left <= 0) return Received::late;
    pollfd waiting{socket_, POLLIN, 0};
    constexpr double longest = 1e9;
    if (poll(&waiting, 1, static_cast<int>(std::ceil(std::min(left, longest)))) <= 0) continue;
    const ssize_t count = recv(socket_, next, size, 0);
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) return Received::end;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return Received::all;
}

bool Child::send(const Message& message) const {
  const auto send_all = [this](const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t count = ::send(socket_, next, size, MSG_NOSIGNAL);
      if (count == -1 && errno == EINTR) continue;
      if (count <= 0) return false;
      next += count;
      size -= static_cast<std::size_t>(count);
    }
    return true;
  };
  const std::size_t size = message.bytes().size();
  return send_all(&size, sizeof size) && send_all(message.bytes().data(), size);
}

int Child::wait() {
  int status = 0;
  while (waitpid(process_, &status, 0) == -1 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

Death Child::kill(FaultKind kind, std::string words) {
  ::kill(process_, SIGKILL);
  wait();
  return {kind, words + last_words()};
}

/// The process has closed its end of the connection, most likely because it ended.
Death Child::death() {
  constexpr std::chrono::milliseconds patience(2000), step(1);
  siginfo_t ended{};
  for (auto waited = step * 0; waited < patience && ended.si_pid == 0; waited += step) {
    if (waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == -1) break;
    if (ended.si_pid == 0) std::this_thread::sleep_for(step);
  }
  if (ended.si_pid == 0) return kill(FaultKind::protocol, "closed a descriptor that is not its own");
  const int status = wait();
  if (WIFSIGNALED(status)) return {FaultKind::crash, signal_text(WTERMSIG(status)) + last_words()};
  return {FaultKind::exit,
          fmt::format("ended the process with status {}", WEXITSTATUS(status)) + last_words()};
}

/// The last characters that the process wrote to standard error.
std::string Child::last_words() const {
  constexpr off_t most = 200;
  const off_t size = lseek(error_.number(), 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, most)), '\0');
  const ssize_t count = pread(error_.number(), text.data(), text.size(), std::max<off_t>(size - most, 0));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  }
  return text.empty() ? "" : ", saying: " + text;
}

}  // namespace nipref::verify
