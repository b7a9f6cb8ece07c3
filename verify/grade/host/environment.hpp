#pragma once
#include <cfenv>
#include <cstdint>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include <nipref/verify/grade/internal/protocol.hpp>

// The part of the floating-point environment that controls how this thread computes, without the flags of exceptions.
namespace nipref::verify::host {

#if defined(__x86_64__)
struct Environment {
  std::uint32_t mxcsr;
  std::uint16_t x87;
};

inline constexpr std::uint32_t mxcsr_flags = 0x3f;

inline Environment environment() {
  std::uint16_t x87 = 0;
  asm volatile("fnstcw %0" : "=m"(x87));
  return {_mm_getcsr() & ~mxcsr_flags, x87};
}

inline void set_environment(const Environment& wanted) {
  _mm_setcsr(wanted.mxcsr);
  asm volatile("fldcw %0" : : "m"(wanted.x87));
}

/// The protocol::Changes between two environments.
inline std::uint32_t changes(const Environment& before, const Environment& after) {
  const std::uint32_t mxcsr = before.mxcsr ^ after.mxcsr;
  const auto x87 = static_cast<std::uint32_t>(before.x87 ^ after.x87);
  return ((mxcsr & 0x6000) != 0 || (x87 & 0x0c00) != 0 ? protocol::rounding : 0U) |
         ((mxcsr & 0x8000) != 0 ? protocol::flush_to_zero : 0U) |
         ((mxcsr & 0x0040) != 0 ? protocol::denormals_are_zero : 0U) |
         ((mxcsr & 0x1f80) != 0 || (x87 & 0x003f) != 0 ? protocol::traps : 0U) |
         ((x87 & 0x0300) != 0 ? protocol::x87_precision : 0U);
}
#elif defined(__aarch64__)
struct Environment {
  std::uint64_t fpcr;
};

inline Environment environment() {
  Environment now{};
  asm volatile("mrs %0, fpcr" : "=r"(now.fpcr));
  return now;
}

inline void set_environment(const Environment& wanted) { asm volatile("msr fpcr, %0" : : "r"(wanted.fpcr)); }

/// One bit flushes both arguments and results.
inline std::uint32_t changes(const Environment& before, const Environment& after) {
  const std::uint64_t fpcr = before.fpcr ^ after.fpcr;
  return ((fpcr >> 22 & 3) != 0 ? protocol::rounding : 0U) |
         ((fpcr >> 24 & 1) != 0 ? protocol::flush_to_zero | protocol::denormals_are_zero : 0U) |
         ((fpcr >> 8 & 0x9f) != 0 ? protocol::traps : 0U);
}
#else
struct Environment {
  int rounding;
};

inline Environment environment() { return {std::fegetround()}; }

inline void set_environment(const Environment& wanted) { std::fesetround(wanted.rounding); }

inline std::uint32_t changes(const Environment& before, const Environment& after) {
  return before.rounding != after.rounding ? protocol::rounding : 0U;
}
#endif

}  // namespace nipref::verify::host
