#include <nipref/verify/grade/baseline.hpp>

#include "reading.hpp"

using namespace nipref;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const GivenFile file(data, size);
  take_or_refuse([&] { static_cast<void>(verify::Baseline::read(file.path()).text()); });
  return 0;
}
