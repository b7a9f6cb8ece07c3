/* A user's kernels for the README's commands: I2 is the sign times pi/2. */
#include <math.h>
#include <nipref/kernel.h>

double f(double alpha) { return alpha == 0 ? 0 : copysign(1.5707963267948966, alpha); }

static int evaluate(void* state, size_t n, const double* const* arguments, double* out) {
  (void)state;
  for (size_t i = 0; i < n; ++i) out[i] = f(arguments[0][i]);
  return 0;
}
static const nipref_kernel mine = {NIPREF_KERNEL_ABI, sizeof(nipref_kernel), "mine", "I2", 1, 0, 0, evaluate, 0};
const nipref_kernel* const* nipref_kernels(void) {
  static const nipref_kernel* const all[] = {&mine, 0};
  return all;
}
