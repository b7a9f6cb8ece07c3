#include <cstring>
#include <memory>
#include <vector>

#include <nipref/verify/grade/internal/exchange.hpp>
#include <nipref/verify/grade/plugin.hpp>

#include "reading.hpp"

using namespace nipref;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t points = 2, passes = 3;

/// The answer of a host with one sound kernel of I1, up to the end of its list of kernels.
std::string sound_answer() {
  const auto exchange = std::make_unique<verify::protocol::Exchange>();
  exchange->kernels = 1;
  auto& kernel = exchange->kernel_list[0];
  kernel.name = {"k"};
  kernel.quantity = {"I1"};
  kernel.arity = 1;
  const char* const first = reinterpret_cast<const char*>(exchange.get());
  return {first, reinterpret_cast<const char*>(&kernel + 1)};
}

}  // namespace

/// Starts with a sound answer, because there are no files of answers.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned) {
  const std::string answer = sound_answer();
  if (size > 1 || most < answer.size()) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, answer.data(), answer.size());
  return answer.size();
}

/// Reads a plugin whose host is a stand-in: it answers every request with the given bytes.
void read_given(const std::string&, const GivenFile& file) {
  setenv("NIPREF_KERNEL_HOST", NIPREF_STAND_IN, 1);
  take_or_refuse([&] {
    const verify::Plugin plugin{file.path(), {}, 5};
    const verify::KernelInfo info = verify::kernels_of(plugin).front();
    const auto kernel = verify::open_kernel(plugin, info.name);
    const std::vector<verify::Point> at(points, verify::Point(info.arity));
    std::vector<double> values(points);
    kernel->evaluate(at, values);
    static_cast<void>(kernel->seconds(at, passes));
    static_cast<void>(kernel->faults());
  });
}
