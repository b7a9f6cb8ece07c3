#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include <nipref/verify/grade/fault.hpp>
#include <nipref/verify/grade/internal/protocol.hpp>

namespace nipref::verify {

/// A descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

/// The plugin that a host process loads, and how.
struct HostOrders {
  std::filesystem::path file;
  std::string symbol;  ///< empty: what it lists
  std::uint32_t arity;
  std::uint32_t flags;
  double time_limit;  ///< seconds for an answer
};

/// How a child ended.
struct Death {
  FaultKind kind;
  std::string words;
};

/// A process that holds a plugin: nipref-kernel-host. After a Death it is gone and is asked nothing more. Used by one
/// thread at a time.
class Child {
 public:
  using Answer = std::variant<protocol::Message, Death>;

  /// std::system_error if no process can be made; BadInput as kernel_host has it.
  explicit Child(const HostOrders& orders);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  /// Ends the process.
  ~Child();

  /// The first message of the process: the result of loading the plugin.
  Answer greeting();
  /// Its answer to a request, within the time limit.
  Answer ask(const protocol::Message& request);

 private:
  Answer receive(double time_limit);
  using Instant = std::chrono::steady_clock::time_point;
  enum class Received { all, end, late };
  Received receive(void* data, std::size_t size, Instant deadline) const;
  [[nodiscard]] bool send(const protocol::Message& message) const;
  Death death();
  Death kill(FaultKind kind, std::string words);
  int wait();
  [[nodiscard]] std::string last_words() const;

  double time_limit_;
  Descriptor said_, complained_;  ///< its standard output and standard error
  int talk_ = -1;
  pid_t process_ = -1;
};

/// The program nipref-kernel-host: what the environment variable NIPREF_KERNEL_HOST says; else where it lies beside the
/// running program, where it was installed, where it was built. BadInput naming the variable if there is none.
std::filesystem::path kernel_host();

}  // namespace nipref::verify
