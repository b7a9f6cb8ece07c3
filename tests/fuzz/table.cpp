#include <nipref/data/table/index.hpp>

#include "reading.hpp"

using namespace nipref;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const GivenFile file(data, size);
  take_or_refuse([&] { static_cast<void>(data::summarize(data::load_table(file.path()))); });
  return 0;
}
