#pragma once
#include <sys/types.h>

#include <cstdint>

#include <nipref/verify/grade/internal/exchange.hpp>
#include <nipref/verify/grade/plugin.hpp>
#include <nipref/verify/support/internal/common.hpp>
#include <nipref/verify/support/internal/process.hpp>

namespace nipref::verify {

/// A fault of a call.
struct Trouble {
  FaultKind kind;
  std::string words;
};

/// A process that runs nipref-kernel-host with a plugin. After it has ended, which is a Trouble, it must not be asked
/// again. Only one thread may use it at a time.
class Child {
 public:
  /// Starts the process. std::system_error if this fails; BadInput that names the variable NIPREF_KERNEL_HOST if the
  /// program is not found.
  explicit Child(const Plugin& plugin);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Ends the process.
  ~Child();

  /// The request's numbers before asking, and the answer's afterwards.
  [[nodiscard]] protocol::Exchange& exchange() { return *exchange_; }
  /// Waits for the answer, within the time limit; how the process ended if it did.
  std::optional<Trouble> ask(protocol::Request request);
  [[nodiscard]] bool has_ended() const { return process_ == -1; }

 private:
  Trouble kill(FaultKind kind, std::string words);
  Trouble death();
  int wait();
  [[nodiscard]] std::string last_words() const;

  double time_limit_;
  Descriptor output_, error_, memory_;
  std::unique_ptr<protocol::Exchange, void (*)(protocol::Exchange*)> exchange_;
  std::optional<Descriptor> connection_;
  std::uint64_t asked_ = 0;
  pid_t process_ = -1;
};

}  // namespace nipref::verify
