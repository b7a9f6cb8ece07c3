/* Kernels that are wrong on purpose, and some that are right. Most are wrong at 17.25 only. */

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <nipref/fast/sheet/c.h>
#include <nipref/kernel.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

static const double here = 17.25;

static double sound_I1(double alpha) {
  double value = NAN;
  nipref_fast_I1(alpha, &value);
  return value;
}

static double sound(double alpha) {
  double value = NAN;
  nipref_fast_I3(alpha, &value);
  return value;
}

/* The compiler does not know these values, so that it does not remove a fault. */
static volatile int yes = 1;
static volatile double nothing;

static void crash(void) { nothing = *(volatile double*)(uintptr_t)4096; }

static void hang(void) {
  while (yes) {
  }
}

static void flush(void) {
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8000);
#elif defined(__aarch64__)
  uint64_t fpcr;
  __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
  __asm__ volatile("msr fpcr, %0" : : "r"(fpcr | 1 << 24));
#endif
}

/* Computes one value from one point. */
#define EACH(name, expression)                                                          \
  static int name(void* state, size_t n, const double* const* arguments, double* out) { \
    (void)state;                                                                        \
    for (size_t i = 0; i < n; ++i) {                                                    \
      const double x = arguments[0][i];                                                 \
      out[i] = (expression);                                                            \
    }                                                                                   \
    return 0;                                                                           \
  }

EACH(one_pass, sound(x))
static int slow(void* state, size_t n, const double* const* arguments, double* out) {
  for (int i = 0; i < 30; ++i) one_pass(state, n, arguments, out);
  return 0;
}
#if defined(SLOWER)
#define all_sound slow
#else
#define all_sound one_pass
#endif
EACH(all_sound_I1, sound_I1(x))
EACH(no_number, x == here ? NAN : sound(x))
EACH(crashes, (x == here ? crash() : (void)0, sound(x)))
EACH(crashes_always, (crash(), sound(x)))
EACH(crashes_often, ((long)(x * 1e3) % 2 == 0 ? crash() : (void)0, sound(x)))
EACH(hangs, (x == here ? hang() : (void)0, sound(x)))
EACH(hangs_always, (hang(), sound(x)))
EACH(flushes, (x == here ? flush() : (void)0, sound(x)))
EACH(rounds_up, (x == here ? (void)fesetround(FE_UPWARD) : (void)0, sound(x)))
EACH(exits, (x == here ? exit(0) : (void)0, sound(x)))
EACH(prints, (x == here ? (void)printf("hello\n") : (void)0, sound(x)))
EACH(aborts, (x == here ? (fprintf(stderr, "I have had enough\n"), abort()) : (void)0, sound(x)))
EACH(first_is_other, i == 0 ? sound(x) * (1 + 0x1p-50) : sound(x))
EACH(crashes_in_batches, (n > 3 && x == here ? crash() : (void)0, sound(x)))

static int one_too_many(void* state, size_t n, const double* const* arguments, double* out) {
  out[n] = 1;
  return all_sound(state, n, arguments, out);
}

static int one_too_early(void* state, size_t n, const double* const* arguments, double* out) {
  out[-1] = 1;
  return all_sound(state, n, arguments, out);
}

static int reads_too_much(void* state, size_t n, const double* const* arguments, double* out) {
  nothing = arguments[0][n];
  return all_sound(state, n, arguments, out);
}

static int changes_arguments(void* state, size_t n, const double* const* arguments, double* out) {
  const int status = all_sound(state, n, arguments, out);
  for (size_t i = 0; i < n; ++i) {
    if (arguments[0][i] == here) ((double*)arguments[0])[i] = 0;
  }
  return status;
}

static int leaves_out(void* state, size_t n, const double* const* arguments, double* out) {
  (void)state;
  for (size_t i = 0; i < n; ++i) {
    if (arguments[0][i] != here) out[i] = sound(arguments[0][i]);
  }
  return 0;
}

static int refuses(void* state, size_t n, const double* const* arguments, double* out) {
  for (size_t i = 0; i < n; ++i) {
    if (arguments[0][i] == here) return 7;
  }
  return all_sound(state, n, arguments, out);
}

/* Like a kernel with its work space in static memory. */
static volatile double shared;
static double by_shared(double x) {
  shared = x;
  nothing = sound(here);
  return sound(shared);
}
EACH(shares, by_shared(x))

static int sound_I6(void* state, size_t n, const double* const* arguments, double* out) {
  (void)state;
  for (size_t i = 0; i < n; ++i) {
    if (nipref_fast_I6(arguments[0][i], arguments[1][i], &out[i]) != 0) out[i] = NAN;
  }
  return 0;
}

/* A state that the kernel needs. */
static int make(void** state) {
  if (*state != NULL) return 1;
  *state = malloc(sizeof(double));
  *(double*)*state = 1;
  return 0;
}

static int with_state(void* state, size_t n, const double* const* arguments, double* out) {
  if (state == NULL || *(double*)state != 1) return 9;
  return all_sound(state, n, arguments, out);
}

static void unmake(void* state) {
  *(double*)state = 0;
  free(state);
}

static int not_made(void** state) {
  (void)state;
  return 3;
}

static void crash_at_the_end(void* state) {
  (void)state;
  crash();
}

/* Writes an empty answer where the host writes its own. */
static int speak(void** state) {
  const size_t nothing = 0;
  (void)state;
  return write(3, &nothing, sizeof nothing) < 0;
}

static void speak_at_the_end(void* state) { speak(state); }

double bare_I3(double alpha) { return sound(alpha); }

double bare_I6(double alpha, double eta) {
  double value = NAN;
  nipref_fast_I6(alpha, eta, &value);
  return value;
}

double bare_shares(double alpha) { return by_shared(alpha); }

#define KERNEL(name, quantity, arity, flags, open, evaluate, close) \
  static const nipref_kernel k_##name = {                           \
      NIPREF_KERNEL_ABI, sizeof(nipref_kernel), #name, quantity, arity, flags, open, evaluate, close};
#define I3(evaluate) KERNEL(evaluate, "I3", 1, 0, 0, evaluate, 0)
#define ADDRESS(evaluate) &k_##evaluate,
/* The kernels of I3 without a state. DO is applied to each of them. */
#define OF_I3(DO) \
  DO(no_number) DO(crashes) DO(crashes_always) DO(crashes_often) DO(hangs) DO(hangs_always) DO(flushes) DO(rounds_up) \
  DO(exits) DO(prints) DO(aborts) DO(first_is_other) DO(crashes_in_batches) DO(slow) DO(one_too_many) DO(one_too_early) \
  DO(reads_too_much) DO(changes_arguments) DO(leaves_out) DO(refuses)

KERNEL(all_sound, "I3", 1, nipref_kernel_thread_safe, 0, all_sound, 0)
KERNEL(all_sound_I1, "I1", 1, nipref_kernel_thread_safe, 0, all_sound_I1, 0)
KERNEL(sound_I6, "I6", 2, nipref_kernel_thread_safe, 0, sound_I6, 0)
KERNEL(with_state, "I3", 1, nipref_kernel_thread_safe, make, with_state, unmake)
KERNEL(shares, "I3", 1, nipref_kernel_thread_safe, 0, shares, 0)
KERNEL(not_opened, "I3", 1, 0, not_made, all_sound, 0)
KERNEL(not_closed, "I3", 1, 0, 0, all_sound, crash_at_the_end)
KERNEL(speaks, "I3", 1, 0, speak, all_sound, 0)
KERNEL(speaks_last, "I3", 1, 0, 0, all_sound, speak_at_the_end)
OF_I3(I3)

const nipref_kernel* const* nipref_kernels(void) {
  static const nipref_kernel* const all[] = {
      &k_all_sound, &k_all_sound_I1, &k_sound_I6, &k_with_state, &k_shares, OF_I3(ADDRESS)
      &k_not_opened, &k_not_closed, &k_speaks, &k_speaks_last, NULL};
  return all;
}
