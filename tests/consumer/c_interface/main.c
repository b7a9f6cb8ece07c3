#include <nipref/nipref.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  const nipref_quantity* un = nipref_find("un");
  const double argument[] = {0.5, 2.0, 0.3}; /* alpha, young, poisson */
  const char* exact[] = {"0.5", "2", "0.3"};
  const double alpha[] = {0.5, 1, 2}, young[] = {2, 2, 2}, poisson[] = {0.3, 0.3, 0.3};
  const double* columns[] = {alpha, young, poisson};
  double value, values[3];
  char digits[80], error[40];
  const char* written[] = {"t=1", "T=2", "material=standard-linear-solid(bulk=1, relaxation_time=2)", NULL};
  const char* overrides[] = {"load.per_length=200", "wanted=[\"contact_length\", \"pressure\"]", "profile.points=3", NULL};
  const double *numbers, *errors;
  double point[256];
  char texts[1000];
  nipref_solution* contact;
  int proven;

  if (nipref_fast(un, argument, 0, &value) == 0) printf("un = %.17g in double\n", value);
  if (nipref_ref(un, exact, 30, digits, sizeof digits, error, sizeof error, &proven) == 0)
    printf("un = %s +- %s, %s\n", digits, error, proven ? "proven" : "estimated");
  if (nipref_fast_batch(un, 3, columns, 1e-6, values) == 0) printf("un(2) = %.5g\n", values[2]);
  if (nipref_fast(un, columns[0], 0, &value) == nipref_bad_input) puts(nipref_last_error());
  if (nipref_find("wn") == NULL) puts(nipref_last_error());
  if (nipref_arity(nipref_find("Un")) > sizeof point / sizeof *point) return 1;
  if (nipref_parse(nipref_find("Un"), written, point, texts, sizeof texts) == 0 &&
      nipref_fast(nipref_find("Un"), point, 0, &value) == 0)
    printf("Un = %.9g of %.3s\n", value, texts);
  if (nipref_parse(nipref_find("Un"), written, point, texts, 10) == nipref_bad_input) puts(nipref_last_error());

  if (nipref_solve("thick-frictionless", overrides, 0, &contact) != 0) return 1;
  printf("%d places", (int)nipref_solution_numbers(contact, "positions", &numbers, &errors));
  printf(", %d pressures", (int)nipref_solution_numbers(contact, "pressure", &numbers, &errors));
  printf(", the last is %g", numbers[2]);
  nipref_solution_numbers(contact, "contact_length", &numbers, &errors);
  printf(", L = %.9g, its error is small: %d\n", *numbers, *errors < 1e-10 * *numbers);
  if (nipref_solution_numbers(contact, "creep_ratio", &numbers, &errors) != 0 || numbers != NULL) return 1;
  if (strstr(nipref_solution_json(contact), "\"unit\": \"length\"") == NULL) return 1;
  nipref_solution_free(contact);
  if (nipref_solve("title = 1\n", NULL, 0, &contact) == nipref_bad_input) puts(nipref_last_error());
  return 0;
}
