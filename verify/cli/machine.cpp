#include <fmt/format.h>

#include <fstream>
#include <thread>

#include <nipref/fast/sheet/instruction_set.hpp>
#include <nipref/verify/cli/machine.hpp>

namespace nipref::verify {
namespace {

/// What Linux calls the processor; elsewhere "unknown processor".
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

}  // namespace

std::string build_description() {
#ifdef __OPTIMIZE__
  constexpr auto kind = "optimised";
#else
  constexpr auto kind = "not optimised: its times mean nothing";
#endif
#ifdef __clang__
  constexpr auto compiler = "Clang";
#else
  constexpr auto compiler = "GCC";
#endif
  return fmt::format("{} {}, {}", compiler, __VERSION__, kind);
}

std::string machine_description() {
  return fmt::format("{}, {} cores; fast runs its code for {}", processor_name(),
                     std::thread::hardware_concurrency(), fast::instruction_set());
}

}  // namespace nipref::verify
