// Runs a plugin for the program that grades it: nipref-kernel-host FILE SYMBOL ARITY FLAGS SECONDS. exchange.hpp
// describes how they talk. It is a separate program so that no fault of the plugin affects nipref.

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <string>

#include <nipref/verify/grade/host/host.hpp>

#if defined(__SANITIZE_ADDRESS__)
extern "C" const char* __asan_default_options();
/// A plugin that ends the process need not free its memory.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace {

using namespace nipref::verify;
using namespace nipref::verify::host;
using protocol::Exchange;
using protocol::Request;

/// Forbids core dumps, as crashes are expected, and limits the size of files.
void limit_resources() {
  constexpr rlim_t largest_file = 64 << 20;
  const rlimit none{0, 0}, file{largest_file, largest_file};
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_FSIZE, &file);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Maps the memory that is standard input at the start, which then has nothing to read.
Exchange& shared_memory() {
  void* const memory = mmap(nullptr, sizeof(Exchange), PROT_READ | PROT_WRITE, MAP_SHARED, STDIN_FILENO, 0);
  if (memory == MAP_FAILED || close(STDIN_FILENO) != 0 || open("/dev/null", O_RDONLY) != STDIN_FILENO)
    _exit(2);
  return *static_cast<Exchange*>(memory);
}

/// Cuts the text if need be.
void copy(const std::string& text, std::span<char> to) {
  const std::size_t size = text.copy(to.data(), to.size() - 1);
  to[size] = '\0';
}

class Host {
 public:
  explicit Host(char** words) : words_(words), exchange_(shared_memory()) {}

  void answer() {
    switch (exchange_.request) {
      case Request::load:
        load();
        break;
      case Request::open:
        kernel_ = &kernels_.at(exchange_.kernel);
        exchange_.status = kernel_->entry.open == nullptr ? 0 : kernel_->entry.open(&kernel_->state);
        break;
      case Request::close:
        if (kernel_->entry.close != nullptr) kernel_->entry.close(kernel_->state);
        kernel_->state = nullptr;
        exchange_.status = 0;
        break;
      case Request::evaluate:
        trial_.evaluate(*kernel_, exchange_);
        break;
      case Request::time:
        trial_.time(*kernel_, exchange_);
    }
    exchange_.noticed = noticed();
  }

 private:
  void load() try {
    kernels_ = load_kernels(words_[0], words_[1], static_cast<std::uint32_t>(std::stoul(words_[2])),
                            static_cast<std::uint32_t>(std::stoul(words_[3])));
    for (std::size_t i = 0; i < kernels_.size(); ++i) {
      const nipref_kernel& entry = kernels_[i].entry;
      auto& listed = exchange_.kernel_list[i];
      copy(entry.name, listed.name);
      copy(entry.quantity, listed.quantity);
      listed.arity = entry.arity;
      listed.flags = entry.flags;
    }
    exchange_.kernels = kernels_.size();
    exchange_.status = 0;
  } catch (const std::exception& error) {
    copy(error.what(), exchange_.failure);
    exchange_.status = 1;
  }

  char** words_;
  Exchange& exchange_;
  Trial trial_;
  std::vector<Kernel> kernels_;
  Kernel* kernel_ = nullptr;
};

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fputs("nipref-kernel-host is called by nipref grade and by nothing else\n", stderr);
    return 2;
  }
  limit_resources();
  watch_guards();
  // A timer ends a call that takes too long if the program, which would do so earlier, has ended.
  constexpr double delay = 5;
  const auto longest =
      static_cast<unsigned>(std::ceil(std::max(std::stod(words[5]), protocol::seconds_to_begin) + delay));
  Host host(words + 1);
  for (std::uint64_t request = 0;
       recv(protocol::connection, &request, sizeof request, 0) == sizeof request;) {
    alarm(longest);
    host.answer();
    alarm(0);
    if (send(protocol::connection, &request, sizeof request, MSG_NOSIGNAL) != sizeof request) break;
  }
  _exit(0);
}
