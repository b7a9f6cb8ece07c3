#pragma once

/* A shared object offers kernels to nipref, which measures their errors and their speed, like this:

       #include <nipref/kernel.h>

       static int my_I1(void* state, size_t n, const double* const* arguments, double* out) {
         for (size_t i = 0; i < n; ++i) out[i] = kernel(arguments[0][i]);
         return 0;
       }
       static const nipref_kernel mine = {NIPREF_KERNEL_ABI, sizeof(nipref_kernel), "mine", "I1", 1, 0, 0, my_I1, 0};
       const nipref_kernel* const* nipref_kernels(void) {
         static const nipref_kernel* const all[] = {&mine, 0};
         return all;
       }

       cc -shared -fPIC mine.c -o mine.so && nipref grade ./mine.so

   A shared object is loaded into a separate process, which may crash, hang or end without harm to nipref. A function
   `double f(double, ...)` with as many arguments as a quantity has does not need this header: `--symbol f
   --quantity I1`.

   New members are added at the end of the structure only; the ABI number changes if the meaning of a member changes.
   Objects that were compiled with an older header, whose structure is shorter, remain valid. */

#include <stddef.h>
#include <stdint.h>

#define NIPREF_KERNEL_ABI 1

#if defined(__GNUC__)
#define NIPREF_KERNEL_EXPORT __attribute__((visibility("default")))
#else
#define NIPREF_KERNEL_EXPORT
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Flags of a kernel, which are added. */
enum {
  /* `evaluate` may be called from several threads at once with the same state. nipref then does so, and the values must
     be the same, bit for bit. */
  nipref_kernel_thread_safe = 1
};

typedef struct nipref_kernel {
  uint32_t abi;  /* NIPREF_KERNEL_ABI */
  uint32_t size; /* sizeof(nipref_kernel) */

  /* The name of the kernel: one line of less than 256 bytes, different for each kernel of the object. */
  const char* name;

  /* The quantity that it computes, as `nipref list` names it. */
  const char* quantity;

  /* The number of the quantity's arguments, in the order of `nipref list QUANTITY` and in its units; a choice is its
     number in the list of choices, from 0. */
  uint32_t arity;

  uint32_t flags; /* 0 or flags as above */

  /* Makes the state that the kernel keeps between calls. It is called before the first call of `evaluate`, from the
     same thread. It returns 0 and sets *state, which was null, or it returns another number, which is reported. It may be
     called again after `close`. `open` is a null pointer for a kernel without a state. */
  int (*open)(void** state);

  /* Computes the values at n >= 1 points, out[i] from arguments[0][i], ..., arguments[arity - 1][i] for 0 <= i < n.
     The arguments are finite, lie in the quantity's domain and must not be changed. The arrays are aligned like
     doubles; the memory next to them must not be accessed. It returns 0, or another number, which is reported and
     makes nipref ignore the values.

     The value at a point must depend on this point only, not on its position among the others or on earlier calls,
     bit for bit. The function must leave the rounding mode as it was, must not flush small numbers to zero, must not
     write to standard output, and must return. */
  int (*evaluate)(void* state, size_t n, const double* const* arguments, double* out);

  /* Frees the state of `open`. It is a null pointer if there is nothing to free. nipref calls it once as a test; a
     process that is no longer needed is ended without it. */
  void (*close)(void* state);
} nipref_kernel;

/* The function that the object exports: it returns a list of at most 1024 kernels, which ends with a null pointer and
   exists as long as the object is loaded. */
NIPREF_KERNEL_EXPORT const nipref_kernel* const* nipref_kernels(void);

#ifdef __cplusplus
}
#endif
