#include <nipref/data/table/index.hpp>

#include "reading.hpp"

using namespace nipref;

void read_given(const std::string&, const GivenFile& file) {
  take_or_refuse([&] { static_cast<void>(data::summarize(data::load_table(file.path()))); });
}
