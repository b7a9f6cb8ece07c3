#pragma once

/* How a shared object shows its kernels to nipref, which measures their errors and their speed:

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

   A shared object is loaded into a process of its own, which may crash, hang or end without harm to nipref. A function
   `double f(double, ...)` of as many arguments as a quantity has needs nothing of this: `--symbol f --quantity I1`.

   Members are only ever added, at the end of the structure; the ABI number changes if one ever means something else.
   An object that was compiled with an older header, whose structure is shorter, goes on to be understood. */

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

/* Flags of a kernel, added up. */
enum {
  /* `evaluate` may be called from several threads at once with the same state. It then is, and has to give the same
     values, bit for bit. */
  nipref_kernel_thread_safe = 1
};

typedef struct nipref_kernel {
  uint32_t abi;  /* NIPREF_KERNEL_ABI */
  uint32_t size; /* sizeof(nipref_kernel) */

  /* By which it is asked for and reported: one line, another for each kernel of the object. */
  const char* name;

  /* The quantity that it computes, as `nipref list` names it. */
  const char* quantity;

  /* The number of the quantity's arguments, in the order of `nipref list QUANTITY` and in its units; a choice is its
     number in the list of choices, from 0. */
  uint32_t arity;

  uint32_t flags; /* 0 or flags as above */

  /* Makes what the kernel keeps between calls. Called before the first call of `evaluate`, from the thread that calls
     that. Returns 0 and sets *state, which is null before; or another number, which is reported. Null: there is
     nothing to make, the state is null. It may be called again after `close`. */
  int (*open)(void** state);

  /* Values at n >= 1 points: out[i] of arguments[0][i], ..., arguments[arity - 1][i] for 0 <= i < n. Arguments are
     finite, lie in the quantity's domain and are not to be changed. The arrays are aligned as doubles are, no more;
     just before and behind them lies memory that must not be touched. Returns 0; or another number, which is reported,
     and the values are not looked at.

     What is asked of it besides its values: that a point's value depends on nothing but the point, neither on its
     place among the others nor on earlier calls, bit for bit; that the processor rounds afterwards as it did before and
     flushes no small numbers to zero; that nothing is written to standard output; that it returns. */
  int (*evaluate)(void* state, size_t n, const double* const* arguments, double* out);

  /* Ends what `open` made. Null: there is nothing to end. Called once, to see that it can be; a process that is no longer
     needed is ended without it. */
  void (*close)(void* state);
} nipref_kernel;

/* The one function that the object exports: a list of kernels, ended by a null pointer, that lasts as long as the object
   is loaded. */
NIPREF_KERNEL_EXPORT const nipref_kernel* const* nipref_kernels(void);

#ifdef __cplusplus
}
#endif
