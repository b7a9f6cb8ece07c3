#include <nipref/nipref.h>
#include <stdio.h>

int main(void) {
  const nipref_quantity* un = nipref_find("un");
  const double argument[] = {0.5, 2.0, 0.3}; /* alpha, young, poisson */
  const char* exact[] = {"0.5", "2", "0.3"};
  const double alpha[] = {0.5, 1, 2}, young[] = {2, 2, 2}, poisson[] = {0.3, 0.3, 0.3};
  const double* columns[] = {alpha, young, poisson};
  double value, values[3];
  char digits[80], error[40];
  int proven;

  if (nipref_fast(un, argument, 0, &value) == 0) printf("un = %.17g in double\n", value);
  if (nipref_ref(un, exact, 30, digits, sizeof digits, error, sizeof error, &proven) == 0)
    printf("un = %s +- %s, %s\n", digits, error, proven ? "proven" : "estimated");
  if (nipref_fast_batch(un, 3, columns, 1e-6, values) == 0) printf("un(2) = %.5g\n", values[2]);
  if (nipref_fast(un, columns[0], 0, &value) == nipref_bad_input) puts(nipref_last_error());
  if (nipref_find("wn") == NULL) puts(nipref_last_error());
  return 0;
}
