#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// The program and the process that holds a plugin, the host, exchange messages over one descriptor. A message is a
// number of bytes, followed by so many bytes. The host sends the first message:
//
//   greeting  reason of a failure (text, empty if there is none), Noticed, number of kernels; for each: name, quantity,
//             arity, flags
//
// Then it answers the program's requests:
//
//   open      number of the kernel                   -> Noticed, what `open` returned
//   close     -                                      -> Noticed
//   evaluate  number of points, columns of arguments -> Noticed, what `evaluate` returned, values, values in another
//                                                       order of points, values from several threads
//   time      passes, number of points, columns      -> what `evaluate` returned, seconds for all passes
namespace nipref::verify::protocol {

/// The descriptor in the host.
inline constexpr int descriptor = 3;

/// A request has no more points than this.
inline constexpr std::size_t most_points = 4096;

/// A point has no more arguments than this.
inline constexpr std::size_t most_arguments = 16;

/// The seconds that loading and opening may take, if the time limit is shorter: a kernel may compute tables then.
inline constexpr double seconds_to_begin = 30;

enum class Request : std::uint32_t { open, close, evaluate, time };

/// The changes of the floating-point environment that a call left; they are undone.
enum Changes : std::uint32_t {
  rounding = 1,       ///< the rounding mode is not to nearest
  flush_to_zero = 2,  ///< small results become 0
  denormals_are_zero = 4,
  traps = 8,          ///< floating-point exceptions are no longer masked
  x87_precision = 16  ///< the x87 unit has another precision
};

/// Forbidden actions of a call.
enum Offences : std::uint32_t {
  output_overrun = 1,     ///< it accessed memory before or behind its output
  arguments_overrun = 2,  ///< it accessed memory before or behind its arguments
  arguments_changed = 4,
  printed = 8  ///< it wrote to standard output
};

struct Noticed {
  std::uint32_t changes = 0;   ///< of Changes
  std::uint32_t offences = 0;  ///< of Offences

  [[nodiscard]] bool any() const { return changes != 0 || offences != 0; }
};

/// The bits of a value that was not written: a NaN that no computation gives.
inline constexpr std::uint64_t unwritten_bits = 0x7ff8'6e69'7072'6566;

/// A sequence of bytes that are read in the order in which they were written.
class Message {
 public:
  Message() = default;
  explicit Message(std::vector<char> bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  requires std::is_trivially_copyable_v<T> Message& put(const T& value) {
    append(&value, sizeof value);
    return *this;
  }
  Message& put_text(const std::string& text) {
    put(text.size());
    append(text.data(), text.size());
    return *this;
  }
  Message& put_column(std::span<const double> column) {
    append(column.data(), column.size_bytes());
    return *this;
  }

  template <class T>
  requires std::is_trivially_copyable_v<T> T take() {
    T value;
    extract(&value, sizeof value);
    return value;
  }
  std::string take_text() {
    std::string text(checked(take<std::size_t>(), 1), '\0');
    extract(text.data(), text.size());
    return text;
  }
  void take_column(std::span<double> column) { extract(column.data(), column.size_bytes()); }

  [[nodiscard]] std::span<const char> bytes() const { return bytes_; }

 private:
  [[nodiscard]] std::size_t checked(std::size_t count, std::size_t size) const {
    if (count > (bytes_.size() - taken_) / size) throw std::length_error("a message is too short");
    return count;
  }
  void append(const void* data, std::size_t size) {
    const char* const first = static_cast<const char*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  void extract(void* data, std::size_t size) {
    std::memcpy(data, bytes_.data() + taken_, checked(size, 1));
    taken_ += size;
  }

  std::vector<char> bytes_;
  std::size_t taken_ = 0;
};

}  // namespace nipref::verify::protocol
