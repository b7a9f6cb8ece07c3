#include <nipref/verify/grade/baseline.hpp>

#include "reading.hpp"

using namespace nipref;

void read_given(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(verify::Baseline::read(file.path()).text()); });
}
