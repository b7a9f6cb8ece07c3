#include <cstdio>
#include <exception>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/number/c_call.hpp>
#include <nipref/fast/sheet/c.h>
#include <nipref/fast/sheet/kernels.hpp>

namespace nipref::fast {
namespace {

thread_local char last_error[512] = "";

int refuse(int code, const std::exception& reason) noexcept {
  std::snprintf(last_error, sizeof last_error, "%s", reason.what());
  return code;
}

/// Writes the kernel's value to *value and returns 0, or returns an error code if the kernel throws.
template <class Kernel>
int give(double* value, Kernel kernel) noexcept {
  return c_call([=] {
    if (value == nullptr) throw data::BadInput("value", "null", "must point to a double");
    *value = kernel();
  });
}

}  // namespace

int c_call(void (*body)(void* context), void* context) noexcept {
  try {
    body(context);
    return 0;
  } catch (const data::BadInput& error) {
    return refuse(nipref_bad_input, error);
  } catch (const std::exception& error) {
    return refuse(nipref_failed, error);
  }
}

}  // namespace nipref::fast

using namespace nipref::fast;

int nipref_fast_I1(double alpha, double* value) {
  return give(value, [=] { return I1(alpha); });
}
int nipref_fast_I2(double alpha, double* value) {
  return give(value, [=] { return I2(alpha); });
}
int nipref_fast_I3(double alpha, double* value) {
  return give(value, [=] { return I3(alpha); });
}
int nipref_fast_I4(double eta, double* value) {
  return give(value, [=] { return I4(eta); });
}
int nipref_fast_I5(double eta, double* value) {
  return give(value, [=] { return I5(eta); });
}
int nipref_fast_I6(double alpha, double eta, double* value) {
  return give(value, [=] { return I6(alpha, eta); });
}
int nipref_fast_I7(double eta, double* value) {
  return give(value, [=] { return I7(eta); });
}
int nipref_fast_F1(double eta, double poisson, double* value) {
  return give(value, [=] { return F1(eta, poisson); });
}
int nipref_fast_F2(double eta, double poisson, double* value) {
  return give(value, [=] { return F2(eta, poisson); });
}

const char* nipref_last_error(void) { return last_error; }
