#include <math.h>

double sign_kernel(double alpha) { return alpha == 0 ? 0 : copysign(1.5707963267948966, alpha); }

double wrong_below_one(double alpha) { return sign_kernel(alpha) * (fabs(alpha) < 1 ? 1.001 : 1); }
