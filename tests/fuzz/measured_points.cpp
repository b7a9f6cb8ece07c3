#include <nipref/verify/grade/measured_points.hpp>

#include "reading.hpp"

using namespace nipref;

/// Golden files are such files too: they name their quantity and have a column of values.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const GivenFile file(data, size);
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), {}, {})); });
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), "I6", "value")); });
  return 0;
}
