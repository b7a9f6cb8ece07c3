#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// What the program and the process that holds a plugin say to each other, over one descriptor: messages, each a number
// of bytes and so many bytes. The host speaks first:
//
//   greeting  why it failed (text, empty: it did not), Noticed, number of kernels; of each: name, quantity, arity,
//             flags
//
// Then it answers, in turn:
//
//   open      number of the kernel                   -> Noticed, what `open` returned
//   close     -                                      -> Noticed
//   evaluate  number of points, columns of arguments -> Noticed, what `evaluate` returned, values, values in another
//                                                       order of points, values from several threads
//   time      passes, number of points, columns      -> what `evaluate` returned, seconds for all passes
namespace nipref::verify::protocol {

/// The host's end of it.
inline constexpr int descriptor = 3;

/// A request has no more points than this.
inline constexpr std::size_t most_points = 4096;

/// A point has no more arguments than this.
inline constexpr std::size_t most_arguments = 16;

/// Loading and opening may take so long, and the time limit if that is more: tables may be made then.
inline constexpr double seconds_to_begin = 30;

enum class Request : std::uint32_t { open, close, evaluate, time };

/// What was found changed after a call, and was put back.
enum Changes : std::uint32_t {
  rounding = 1,       ///< not to nearest
  flush_to_zero = 2,  ///< results
  denormals_are_zero = 4,
  traps = 8,          ///< floating-point exceptions are no longer masked
  x87_precision = 16  ///< of the x87 unit
};

/// What a call did that it must not.
enum Offences : std::uint32_t {
  output_overrun = 1,     ///< touched what lies before or behind its output
  arguments_overrun = 2,  ///< or its arguments
  arguments_changed = 4,
  printed = 8  ///< to standard output
};

struct Noticed {
  std::uint32_t changes = 0;   ///< of Changes
  std::uint32_t offences = 0;  ///< of Offences

  [[nodiscard]] bool any() const { return changes != 0 || offences != 0; }
};

/// A value that was not written: a NaN that no computation makes.
inline constexpr std::uint64_t unwritten_bits = 0x7ff8'6e69'7072'6566;

/// Bytes that are put in and taken out in the same order.
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
