#pragma once

/* The sheet kernels of fast for C and for languages that call C, at full accuracy: definitions, domains and promises are
   those of kernels.hpp and displacements.hpp.

   A function returns 0 and writes *value; or it returns one of the codes below, leaves *value as it was, and
   nipref_last_error() says why. Every function may be called from several threads at once. */

#ifdef __cplusplus
extern "C" {
#endif

enum {
  nipref_failed = 1,   /* for another reason than the arguments */
  nipref_bad_input = 2 /* an argument is outside its domain, a name is unknown, or a pointer is null */
};

int nipref_fast_I1(double alpha, double* value);
int nipref_fast_I2(double alpha, double* value);
int nipref_fast_I3(double alpha, double* value);
int nipref_fast_I4(double eta, double* value);
int nipref_fast_I5(double eta, double* value);
int nipref_fast_I6(double alpha, double eta, double* value);
int nipref_fast_I7(double eta, double* value);
int nipref_fast_F1(double eta, double poisson, double* value);
int nipref_fast_F2(double eta, double poisson, double* value);

/* What was wrong with this thread's latest call that did not return 0, one line "ARGUMENT = VALUE: ALLOWED"; "" if there
   was none. Valid until this thread's next call. */
const char* nipref_last_error(void);

#ifdef __cplusplus
}
#endif
