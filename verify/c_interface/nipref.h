#pragma once

/* Every quantity of nipref's catalogue for C and for languages that call C: in double by `fast`, and to any number of
   digits with an error by `ref`; and contacts. Definitions, arguments and domains: `nipref list QUANTITY`.

   Codes and nipref_last_error() are those of c.h, whose functions libnipref has as well: a program that links libnipref
   does not link libnipref_fast, or the second of the two would not be heard by nipref_last_error().

   Functions that return int return 0 and write their results; or they return nipref_bad_input or nipref_failed, write
   nothing, and nipref_last_error() says why. nipref_ref alone may return nipref_missed, too. Every function may be
   called from several threads at once. */

#include <stddef.h>

#include <nipref/fast/sheet/c.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  nipref_missed = 3 /* results are written, but *error is more than 10^-digits of the quantity's scale */
};

/* A quantity; valid as long as the library is loaded. */
typedef struct nipref_quantity nipref_quantity;

/* "0.1.0" */
const char* nipref_version(void);

/* All quantities, in the catalogue's order. */
size_t nipref_quantity_count(void);
/* Null if number >= nipref_quantity_count(). */
const nipref_quantity* nipref_quantity_at(size_t number);
/* By its name, "I1"; null, and nipref_last_error() names the nearest ones, if there is none of that name. */
const nipref_quantity* nipref_find(const char* name);

/* "I1"; "" for a null pointer, as from the following. */
const char* nipref_name(const nipref_quantity* quantity);
/* One line of mathematics. */
const char* nipref_definition(const nipref_quantity* quantity);
/* How many arguments it takes, and their names in the order in which they are given; "" beyond the last. */
size_t nipref_arity(const nipref_quantity* quantity);
const char* nipref_argument(const nipref_quantity* quantity, size_t number);
/* Largest error of nipref_fast at full accuracy, in units in the last place of the quantity's scale. */
double nipref_promise(const nipref_quantity* quantity);

/* *value in double at `arguments`, nipref_arity() of them. A choice is given by its number, 0 the first that
   `nipref list` names. rtol: the error that may be made, as a part of the scale, 4.44e-16 <= rtol < 1, or 0 for full
   accuracy. */
int nipref_fast(const nipref_quantity* quantity, const double* arguments, double rtol, double* value);

/* values[i] at columns[0][i], columns[1][i], ..., i < points: a column for each argument. All or nothing: one point
   outside the domain refuses them all. */
int nipref_fast_batch(const nipref_quantity* quantity, size_t points, const double* const* columns, double rtol,
                      double* values);

/* The reference at exact decimal (or hexadecimal) texts, one for each argument, null for one's default; choices by
   their names. `digits` 16 to 1000. *value and *error become decimal texts, the error absolute, unit of the value;
   *proven 1 if it is a proven bound, 0 if an estimate. value_size and error_size are the sizes of the buffers; digits +
   40 are enough for the one and 40 for the other, less is refused if the text does not fit. nipref_missed: the digits
   are not all there, as *error tells; the scale is the value, or what `nipref list QUANTITY` says where that is more.
   nipref_last_error() is not about it. */
int nipref_ref(const nipref_quantity* quantity, const char* const* arguments, int digits, char* value,
               size_t value_size, char* error, size_t error_size, int* proven);

/* Arguments as a user writes them: name=value texts, the last pointer null, a material or solid as one of them,
   "material=prony(...)". arguments[i] becomes the double nearest to each, a choice its number, for nipref_fast; `texts`
   the text of each with a line break behind it, for nipref_ref. texts_size is the size of that buffer, at least 1; less
   than the texts take is refused. */
int nipref_parse(const nipref_quantity* quantity, const char* const* assignments, double* arguments, char* texts,
                 size_t texts_size);

/* A contact that was solved; nipref_solution_free() frees it. */
typedef struct nipref_solution nipref_solution;

/* Solves a scene: the text of one, the name of its file, or the name of an example of `nipref help solve`. What has a
   line break is a text. overrides: key=value texts, the last pointer null, that stand for what the scene has there, or
   null. digits: 0 for fast, 16 to 300 for ref. */
int nipref_solve(const char* scene, const char* const* overrides, int digits, nipref_solution** solution);
void nipref_solution_free(nipref_solution* solution);

/* The answer of `nipref solve --json` without what it says of the program: results with errors and units, the shape of
   each, places, warnings. ref's numbers are texts. */
const char* nipref_solution_json(const nipref_solution* solution);

/* How many numbers a result has, 0 if it was not wanted; a profile has one for each of "positions", a field one for each of
   "field.positions", which come again for each of "field.depths". *values and *errors point to the doubles nearest to
   them and to their errors, rounded upwards; null for no such result, and *errors for places. They are valid until
   the solution is freed. */
size_t nipref_solution_numbers(const nipref_solution* solution, const char* result, const double** values,
                               const double** errors);

#ifdef __cplusplus
}
#endif
