#pragma once
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>

#include <nipref/verify/grade/internal/exchange.hpp>
#include <nipref/verify/grade/kernel.h>
#include <nipref/verify/grade/plugin.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/process.hpp>
#include <nipref/verify/support/text.hpp>

namespace nipref::verify {

/// A process that runs nipref-kernel-host with a plugin. After it has ended, which is a Fault, it must not be asked
/// again. Only one thread may use it at a time.
class Child {
 public:
  /// Starts the process. std::system_error if this fails; BadInput that names the variable NIPREF_KERNEL_HOST if the
  /// program is not found.
  explicit Child(const Plugin& plugin)
      : time_limit_(plugin.time_limit),
        output_(file_in_memory(O_APPEND)),
        error_(file_in_memory(O_APPEND)),
        memory_(file_in_memory()),
        exchange_(mapped(memory_.number()), [](Exchange* memory) { munmap(memory, sizeof(Exchange)); }) {
    std::array<int, 2> ends{-1, -1};
    check(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == 0 ? 0 : errno);
    connection_.emplace(ends[0]);
    const Descriptor its_end(ends[1]);
    const BareFunction function = plugin.function.value_or(BareFunction{"", 0});
    process_ = started({kernel_host().string(), std::filesystem::absolute(plugin.file).string(),
                        function.symbol, fmt::format("{}", function.arity),
                        fmt::format("{}", function.thread_safe ? nipref_kernel_thread_safe : 0),
                        fmt::format("{}", time_limit_)},
                       {memory_.number(), output_.number(), error_.number(), its_end.number()}, true);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Ends the process.
  ~Child() {
    if (!has_ended()) kill(FaultKind::given_up, "");
  }

  /// The numbers of the request before ask(), and those of the answer afterwards.
  [[nodiscard]] protocol::Exchange& exchange() { return *exchange_; }
  [[nodiscard]] bool has_ended() const { return process_ == -1; }

  /// Sends the request and waits for the answer within the time limit. Returns how the process ended if it did.
  std::optional<Fault> ask(protocol::Request request) {
    const bool computes = request == Request::evaluate || request == Request::time;
    const double limit = computes ? time_limit_ : std::max(time_limit_, protocol::seconds_to_begin);
    const double whole = std::floor(limit);
    const timeval longest{static_cast<time_t>(whole), static_cast<suseconds_t>(1e6 * (limit - whole)) + 1};
    const int connection = connection_->number();
    setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
    exchange_->request = request;
    ++asked_;
    if (send(connection, &asked_, sizeof asked_, MSG_NOSIGNAL) == -1) return death();
    std::uint64_t answered = 0;
    ssize_t size = 0;
    do size = recv(connection, &answered, sizeof answered, MSG_TRUNC);
    while (size == -1 && errno == EINTR);
    if (size == -1 && errno == EAGAIN)
      return kill(FaultKind::hang, fmt::format("no answer within {} s", limit));
    if (size <= 0) return death();
    if (size == sizeof answered && answered == asked_) return std::nullopt;
    return kill(FaultKind::protocol, "wrote to a descriptor that is not its own");
  }

 private:
  using Exchange = protocol::Exchange;
  using Request = protocol::Request;
  static constexpr auto host_variable = "NIPREF_KERNEL_HOST";

  /// Throws std::system_error unless the error of a system call is 0.
  static void check(int error) {
    if (error != 0) throw std::system_error(error, std::generic_category(), "nipref-kernel-host");
  }

  static Exchange* mapped(int file) {
    check(ftruncate(file, sizeof(Exchange)) == 0 ? 0 : errno);
    void* const memory = mmap(nullptr, sizeof(Exchange), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    check(memory == MAP_FAILED ? errno : 0);
    return static_cast<Exchange*>(memory);
  }

  static std::filesystem::path kernel_host() {
    namespace fs = std::filesystem;
    const auto can_run = [](const fs::path& file) {
      return access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file);
    };
    if (const char* const chosen = std::getenv(host_variable)) {
      if (can_run(chosen)) return chosen;
      throw data::BadInput(host_variable, chosen, "must be the program nipref-kernel-host");
    }
    std::error_code unknown;
    const fs::path beside =
        fs::read_symlink("/proc/self/exe", unknown).parent_path() / NIPREF_HOST_FROM_PROGRAM;
    for (const fs::path& folder : {beside, fs::path(NIPREF_HOST_INSTALLED), fs::path(NIPREF_HOST_BUILT)})
      if (can_run(folder / "nipref-kernel-host")) return folder / "nipref-kernel-host";
    throw data::BadInput(
        host_variable, "(not set)",
        "must be the program nipref-kernel-host, which was not found beside this program nor where it "
        "was installed");
  }

  static std::string signal_text(int signal) {
    const char* const name = sigabbrev_np(signal);
    return name == nullptr ? fmt::format("signal {}", signal)
                           : fmt::format("SIG{} ({})", name, sigdescr_np(signal));
  }

  int wait() { return status_at_end(std::exchange(process_, -1)); }

  Fault kill(FaultKind kind, const std::string& words) {
    ::kill(process_, SIGKILL);
    wait();
    return {kind, {}, words + last_words()};
  }

  /// The fault of a process that has closed its end of the connection, most likely because it ended.
  Fault death() {
    constexpr std::chrono::milliseconds patience(2000), step(1);
    siginfo_t ended{};
    for (auto waited = step * 0; waited < patience && ended.si_pid == 0; waited += step) {
      if (waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) == -1) break;
      if (ended.si_pid == 0) std::this_thread::sleep_for(step);
    }
    if (ended.si_pid == 0) return kill(FaultKind::protocol, "closed a descriptor that is not its own");
    const int status = wait();
    if (WIFSIGNALED(status)) return {FaultKind::crash, {}, signal_text(WTERMSIG(status)) + last_words()};
    return {FaultKind::exit,
            {},
            fmt::format("ended the process with status {}", WEXITSTATUS(status)) + last_words()};
  }

  /// The last characters that the process wrote to standard error.
  [[nodiscard]] std::string last_words() const {
    constexpr off_t most = 200;
    std::array<char, most> last{};
    const off_t start = std::max<off_t>(0, lseek(error_.number(), 0, SEEK_END) - most);
    const ssize_t count = pread(error_.number(), last.data(), most, start);
    std::string text(last.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    text.resize(text.find_last_not_of('\n') + 1);
    return text.empty() ? "" : ", saying: " + in_one_line(text);
  }

  double time_limit_;
  Descriptor output_, error_, memory_;
  std::unique_ptr<Exchange, void (*)(Exchange*)> exchange_;
  std::optional<Descriptor> connection_;
  std::uint64_t asked_ = 0;
  pid_t process_ = -1;
};

}  // namespace nipref::verify
