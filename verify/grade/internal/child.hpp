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

/// A file descriptor that is closed in the destructor.
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

/// The plugin that a host process loads, and its options.
struct HostOrders {
  std::filesystem::path file;
  std::string symbol;  ///< of a bare function; empty if the object lists its kernels
  std::uint32_t arity;
  std::uint32_t flags;
  double time_limit;  ///< seconds for an answer
};

/// How a child ended.
struct Death {
  FaultKind kind;
  std::string words;
};

/// A process that runs nipref-kernel-host with a plugin. After a Death it must not be asked again. Only one thread
/// may use it at a time.
class Child {
 public:
  using Answer = std::variant<protocol::Message, Death>;

  /// Starts the process. std::system_error if this fails; BadInput as of kernel_host.
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
  Descriptor output_, error_;  ///< its standard output and standard error
  int socket_ = -1;
  pid_t process_ = -1;
};

/// The path of nipref-kernel-host: the value of the environment variable NIPREF_KERNEL_HOST, otherwise the first that
/// exists beside the running program, in the folder of the installation, and in that of the build. BadInput that
/// names the variable if there is none.
std::filesystem::path kernel_host();

}  // namespace nipref::verify
