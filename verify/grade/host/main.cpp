// Runs a plugin for the program that grades it: nipref-kernel-host FILE SYMBOL ARITY FLAGS SECONDS. protocol.hpp
// describes their messages. It is a separate program so that no fault of the plugin affects nipref.

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <nipref/verify/grade/host/trial.hpp>

#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __asan_default_options();
/// A plugin that ends the process need not free its memory.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace {

using namespace nipref::verify;
using namespace nipref::verify::host;
using protocol::Message;
using protocol::Request;

/// Ends the host when the program has ended.
[[noreturn]] void leave() { _exit(0); }

void write_all(const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = write(protocol::descriptor, next, size);
    if (written <= 0) leave();
    next += written;
    size -= static_cast<std::size_t>(written);
  }
}

void read_all(void* data, std::size_t size) {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = read(protocol::descriptor, next, size);
    if (count <= 0) leave();
    next += count;
    size -= static_cast<std::size_t>(count);
  }
}

void send(const Message& message) {
  Message whole;
  whole.put(message.bytes().size());
  std::vector<char> bytes(whole.bytes().begin(), whole.bytes().end());
  bytes.insert(bytes.end(), message.bytes().begin(), message.bytes().end());
  write_all(bytes.data(), bytes.size());
}

Message receive() {
  std::size_t size = 0;
  read_all(&size, sizeof size);
  std::vector<char> bytes(size);
  read_all(bytes.data(), bytes.size());
  return Message(std::move(bytes));
}

/// Forbids core dumps, as crashes are expected, and limits the size of files.
void limit_resources() {
  constexpr rlim_t largest_file = 64 << 20;
  const rlimit none{0, 0}, file{largest_file, largest_file};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_FSIZE, &file);
  std::signal(SIGXFSZ, SIG_IGN);
}

class Host {
 public:
  explicit Host(char** arguments) : seconds_(static_cast<unsigned>(std::ceil(std::stod(arguments[4])))) {
    limit();
    load(arguments[0], arguments[1], static_cast<std::uint32_t>(std::stoul(arguments[2])),
         static_cast<std::uint32_t>(std::stoul(arguments[3])));
    alarm(0);
  }

  void serve() {
    for (;;) {
      Message request = receive();
      limit();
      send(answer(request));
      alarm(0);
    }
  }

 private:
  /// A timer ends a call that takes too long if the program, which would do so earlier, has ended.
  void limit() const {
    constexpr unsigned delay = 5;
    alarm(std::max(seconds_, static_cast<unsigned>(protocol::seconds_to_begin)) + delay);
  }

  void load(const std::string& file, const std::string& symbol, std::uint32_t arity, std::uint32_t flags) {
    std::string failure;
    try {
      kernels_ = load_kernels(file, symbol, arity, flags);
    } catch (const std::exception& error) {
      failure = error.what();
    }
    Message greeting;
    greeting.put_text(failure).put(watch_.noticed()).put(kernels_.size());
    for (const Kernel& kernel : kernels_) {
      greeting.put_text(kernel.entry.name).put_text(kernel.entry.quantity);
      greeting.put(kernel.entry.arity).put(kernel.entry.flags);
    }
    send(greeting);
  }

  Message answer(Message& request) {
    switch (request.take<Request>()) {
      case Request::open:
        return open(request.take<std::size_t>());
      case Request::close:
        return close();
      case Request::evaluate:
        return evaluate(request);
      default:
        return time(request);
    }
  }

  Message open(std::size_t number) {
    kernel_ = &kernels_.at(number);
    const int status = kernel_->entry.open == nullptr ? 0 : kernel_->entry.open(&kernel_->state);
    return Message().put(watch_.noticed()).put(status);
  }

  Message close() {
    if (kernel_->entry.close != nullptr) {
      kernel_->entry.close(kernel_->state);
      kernel_->state = nullptr;
    }
    return Message().put(watch_.noticed());
  }

  [[nodiscard]] std::vector<Column> columns(Message& request) const {
    const auto count = request.take<std::size_t>();
    std::vector<Column> columns(kernel_->entry.arity, Column(count));
    for (Column& column : columns) request.take_column(column);
    return columns;
  }

  Message evaluate(Message& request) {
    const Tried tried = trial_.evaluate(*kernel_, columns(request));
    Message answer;
    answer.put(watch_.noticed()).put(tried.status);
    for (const Column* const column : {&tried.values, &tried.permuted, &tried.threaded})
      answer.put_column(*column);
    return answer;
  }

  Message time(Message& request) {
    const auto passes = request.take<std::size_t>();
    int status = 0;
    const double seconds = trial_.time(*kernel_, columns(request), passes, status);
    static_cast<void>(watch_.noticed());
    return Message().put(status).put(seconds);
  }

  unsigned seconds_;
  Watch watch_;
  Trial trial_;
  std::vector<Kernel> kernels_;
  Kernel* kernel_ = nullptr;
};

}  // namespace

int main(int count, char** arguments) {
  constexpr int words = 6;
  if (count != words) {
    std::fputs("nipref-kernel-host is called by nipref grade and by nothing else\n", stderr);
    return 2;
  }
  limit_resources();
  watch_guards();
  Host(arguments + 1).serve();
}
