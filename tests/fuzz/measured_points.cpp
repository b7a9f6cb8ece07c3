#include <nipref/verify/grade/measured_points.hpp>

#include "reading.hpp"

using namespace nipref;

/// Golden files are such files too: they name their quantity and have a column of values.
void read_given(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), {}, {})); });
  take_or_refuse([&] { static_cast<void>(verify::read_measured_points(file.path(), "I6", "value")); });
}
