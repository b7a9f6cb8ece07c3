#pragma once

/* Every quantity of nipref's catalogue, and contacts, for C and for languages that call C: in double by `fast`, and to
   any number of digits with an error by `ref`. Definitions, arguments and domains: `nipref list QUANTITY`.

   Codes and nipref_last_error() are those of c.h, whose functions libnipref has as well. Link libnipref or
   libnipref_fast, but not both: nipref_last_error() does not report the errors of the second of the two.

   Functions that return int return 0 and write their results; or they return nipref_bad_input or nipref_failed and
   write nothing, and nipref_last_error() says why. nipref_ref alone may return nipref_missed, too. Every function may
   be called from several threads at once. */

#include <stddef.h>

#include <nipref/fast/sheet/c.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  nipref_missed = 3 /* results are written, but *error is more than 10^-digits of the quantity's scale */
};

/* A quantity; the pointer is valid as long as the library is loaded. */
typedef struct nipref_quantity nipref_quantity;

/* The version of the library, "0.1.0". */
const char* nipref_version(void);

/* How many quantities there are; they are numbered in the order of the catalogue. */
size_t nipref_quantity_count(void);
/* The quantity of this number; null if number >= nipref_quantity_count(). */
const nipref_quantity* nipref_quantity_at(size_t number);
/* The quantity of this name, "I1"; null if there is none, and nipref_last_error() names the nearest ones. */
const nipref_quantity* nipref_find(const char* name);

/* The name, "I1". For a null pointer the texts here are "" and the numbers 0. */
const char* nipref_name(const nipref_quantity* quantity);
/* The definition: one line of mathematics. */
const char* nipref_definition(const nipref_quantity* quantity);
/* How many arguments it has, and their names in the order in which they are given; "" beyond the last one. */
size_t nipref_arity(const nipref_quantity* quantity);
const char* nipref_argument(const nipref_quantity* quantity, size_t number);
/* The largest error of nipref_fast at full accuracy, in units in the last place of the quantity's scale. */
double nipref_promise(const nipref_quantity* quantity);

/* Sets *value to the value in double at `arguments`, which has nipref_arity() numbers. A choice is given by its number,
   0 for the first that `nipref list` names. rtol is the largest error that is allowed, as a part of the scale, 4.44e-16
   <= rtol < 1, or 0 for full accuracy. */
int nipref_fast(const nipref_quantity* quantity, const double* arguments, double rtol, double* value);

/* Sets values[i] to the value at columns[0][i], columns[1][i], ..., i < points: there is a column for each argument. If
   one point is outside the domain, all are refused. */
int nipref_fast_batch(const nipref_quantity* quantity, size_t points, const double* const* columns,
                      double rtol, double* values);

/* The reference. Its arguments are exact decimal (or hexadecimal) texts, one for each argument, null for a default;
   choices are given by their names. `digits` is 16 to 1000. *value and *error become decimal texts; the error is
   absolute. *proven becomes 1 if the error is a proven bound, 0 if it is an estimate. value_size and error_size are the
   sizes of the buffers: digits + 40 bytes for the value and 40 for the error are enough; a buffer that is too small for
   its text is refused. nipref_missed means that *error is more than 10^-digits of the scale, which is the value, or
   what `nipref list QUANTITY` says if that is larger; nipref_last_error() does not report it. */
int nipref_ref(const nipref_quantity* quantity, const char* const* arguments, int digits, char* value,
               size_t value_size, char* error, size_t error_size, int* proven);

/* Reads arguments as a user writes them: name=value texts, the last pointer null; a material or solid is one of them,
   "material=prony(...)". arguments[i] becomes the double nearest to each, for a choice its number, as nipref_fast takes
   it. `texts` becomes the text of each followed by a line break, for nipref_ref. texts_size is the size of that buffer,
   at least 1; a buffer that is too small is refused. */
int nipref_parse(const nipref_quantity* quantity, const char* const* assignments, double* arguments,
                 char* texts, size_t texts_size);

/* A solved contact; nipref_solution_free() frees it. */
typedef struct nipref_solution nipref_solution;

/* Solves a scene. `scene` is its text if it has a line break, otherwise the name of its file or of an example of
   `nipref help solve`. `overrides` are key=value texts, the last pointer null, that replace values of the scene, or
   null. `digits` is 0 for fast, 16 to 300 for ref. */
int nipref_solve(const char* scene, const char* const* overrides, int digits, nipref_solution** solution);
void nipref_solution_free(nipref_solution* solution);

/* The answer of `nipref solve --json` without what it says of the program: results with errors and units, the shape of
   each result, places, warnings. The numbers of ref are texts. */
const char* nipref_solution_json(const nipref_solution* solution);

/* How many numbers a result has, 0 if it was not wanted. A profile has one for each of "positions". A field has one for
   each of "field.positions" at the first of "field.depths", then at the next. *values and *errors point to the doubles
   nearest to the numbers and to their errors, rounded upwards. They are null if there is no such result, and *errors is
   null for places. They are valid until the solution is freed. */
size_t nipref_solution_numbers(const nipref_solution* solution, const char* result, const double** values,
                               const double** errors);

#ifdef __cplusplus
}
#endif
