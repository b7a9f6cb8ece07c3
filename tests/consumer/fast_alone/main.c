#include <stdio.h>

#include <nipref/fast/sheet/c.h>

int main(void) {
  double value = 0;
  if (nipref_fast_I1(0.73, &value) == 0) printf("I1(0.73) = %.17g\n", value);
  if (nipref_fast_I1(0, &value) == nipref_bad_input) puts(nipref_last_error());
  return 0;
}
