#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace nipref::verify::protocol {

/// The host's end of the connection, a socket. The program sends the number of its request, and the host sends it back
/// when the answer stands in the Exchange. This is shared memory, which the host finds as its standard input.
inline constexpr int connection = 3;

inline constexpr std::size_t most_points = 4096, most_arguments = 16, most_kernels = 1024;

/// The seconds that loading and opening may take, if the time limit is shorter: a kernel may compute tables then.
inline constexpr double seconds_to_begin = 30;

enum class Request : std::uint32_t { load, open, close, evaluate, time };

/// Forbidden actions of a call. Changes of the floating-point environment are undone.
enum Noticed : std::uint32_t {
  output_overrun = 1,     ///< it accessed memory before or behind its output
  arguments_overrun = 2,  ///< it accessed memory before or behind its arguments
  arguments_changed = 4,
  rounding = 8,        ///< the rounding mode is not to nearest
  flush_to_zero = 16,  ///< small results become 0
  denormals_are_zero = 32,
  traps = 64,           ///< floating-point exceptions are no longer masked
  x87_precision = 128,  ///< the x87 unit has another precision
  printed = 256         ///< it wrote to standard output
};

/// The bits of a value that was not written: a NaN that no computation gives.
inline constexpr std::uint64_t unwritten_bits = 0x7ff8'6e69'7072'6566;

using Text = std::array<char, 256>;  ///< ends with a null character
using LongText = std::array<char, 8192>;
using Column = std::array<double, most_points>;

/// A request and its answer. Any number in it may be wrong, as the plugin can write to this memory as well.
struct Exchange {
  Request request;
  std::size_t kernel;  ///< number of the kernel to be opened
  std::size_t points, passes;

  std::uint32_t noticed;  ///< bits of Noticed
  int status;             ///< what the plugin's function returned; for load: not 0 if loading failed
  double seconds;         ///< time of all passes

  std::size_t kernels;  ///< number of loaded kernels
  struct {
    Text name, quantity;
    std::uint32_t arity, flags;
  } kernel_list[most_kernels];
  LongText failure;  ///< why loading failed

  Column values;
  Column permuted;  ///< the values from a call with the points in another order
  /// The values from several threads; equal to `values` for a kernel that is not declared thread-safe.
  Column threaded;
  std::array<Column, most_arguments> arguments;
};

}  // namespace nipref::verify::protocol
