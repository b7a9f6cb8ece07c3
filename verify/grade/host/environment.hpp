#pragma once
#include <cfenv>
#include <cstdint>

#include <nipref/verify/grade/internal/exchange.hpp>

namespace nipref::verify::host {

/// The changes, of protocol::Noticed, that this thread's floating-point environment has from the default, which is
/// restored. The flags of exceptions do not count.
inline std::uint32_t environment_changes() {
  std::uint32_t changes = std::fegetround() == FE_TONEAREST ? 0U : protocol::rounding;
  const auto add = [&](bool changed, std::uint32_t what) { changes |= changed ? what : 0U; };
  std::fenv_t now{};
  std::fegetenv(&now);
#if defined(__x86_64__) && defined(__GLIBC__)
  const std::uint32_t sse = now.__mxcsr ^ 0x1f80U, x87 = now.__control_word ^ 0x037fU;
  add((sse & 0x6000) != 0, protocol::rounding);
  add((sse & 0x8000) != 0, protocol::flush_to_zero);
  add((sse & 0x0040) != 0, protocol::denormals_are_zero);
  add((sse & 0x1f80) != 0 || (x87 & 0x003f) != 0, protocol::traps);
  add((x87 & 0x0300) != 0, protocol::x87_precision);
#elif defined(__aarch64__) && defined(__GLIBC__)
  // One bit flushes both arguments and results.
  add((now.__fpcr >> 24 & 1) != 0, protocol::flush_to_zero | protocol::denormals_are_zero);
  add((now.__fpcr >> 8 & 0x9f) != 0, protocol::traps);
#endif
  std::fesetenv(FE_DFL_ENV);
  return changes;
}

}  // namespace nipref::verify::host
