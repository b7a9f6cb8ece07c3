/* Shared objects that are odd as a whole. The macro that is defined says in what way. */

#include <stdio.h>
#include <stdlib.h>

#include <nipref/kernel.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#if defined(PRINTS_AND_FLUSHES)
/* Like an object made with -ffast-math. */
__attribute__((constructor)) static void on_load(void) {
  printf("loaded\n");
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8040);
#endif
}
#elif defined(CRASHES)
__attribute__((constructor)) static void on_load(void) { abort(); }
#endif

#if defined(EMPTY_LIST)
const nipref_kernel* const* nipref_kernels(void) {
  static const nipref_kernel* const all[] = {NULL};
  return all;
}
#elif !defined(NO_LIST)
static int zero(void* state, size_t n, const double* const* arguments, double* out) {
  (void)state;
  (void)arguments;
  for (size_t i = 0; i < n; ++i) out[i] = 0;
  return 0;
}

#if defined(OTHER_ABI)
#define ABI (NIPREF_KERNEL_ABI + 1)
#else
#define ABI NIPREF_KERNEL_ABI
#endif

/* Like the structure of a newer version, with more members. */
static const struct {
  nipref_kernel known;
#if defined(NEWER)
  double more;
#endif
} kernel = {.known = {ABI, sizeof kernel, "zero", "I3", 1, 0, 0, zero, 0}};

#if defined(FICKLE)
/* The number of arguments differs from one process to the next: a process leaves a file, or removes it. */
static uint32_t arity(void) {
  const char* const file = getenv("NIPREF_TEST_FICKLE");
  if (remove(file) == 0) return 2;
  FILE* const made = fopen(file, "w");
  if (made) fclose(made);
  return 1;
}

const nipref_kernel* const* nipref_kernels(void) {
  static nipref_kernel fickle;
  static const nipref_kernel* const all[] = {&fickle, NULL};
  if (fickle.abi == 0) {
    fickle = kernel.known;
    fickle.arity = arity();
  }
  return all;
}
#else
const nipref_kernel* const* nipref_kernels(void) {
  static const nipref_kernel* const all[] = {&kernel.known, NULL};
  return all;
}
#endif
#endif
