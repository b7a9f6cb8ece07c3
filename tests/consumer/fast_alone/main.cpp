#include <cstdio>

#include <nipref/data/bad_input.hpp>
#include <nipref/fast/sheet/kernels.hpp>

int main() {
  std::printf("I1(0.73) = %.17g\n", nipref::fast::I1(0.73));
  try {
    nipref::fast::I1(0);
  } catch (const nipref::data::BadInput& refused) {
    std::puts(refused.what());
  }
}
