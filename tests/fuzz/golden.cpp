#include <fstream>

#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>

#include "reading.hpp"

using namespace nipref;

/// A file of golden values, and the checksums of a folder of them: the working folder of the run.
void read_given(const std::string& text, const GivenFile&) {
  std::ofstream(verify::checksums_name, std::ios::binary) << text;
  take_or_refuse([&] { static_cast<void>(verify::Checksums::of(".").text()); });
  take_or_refuse([&] {
    const verify::GoldenFile file = verify::read_golden(verify::checksums_name);
    for (const verify::GoldenRow& row : file.rows) static_cast<void>(row.number());
    static_cast<void>(verify::golden_text(file.quantity(), file));
  });
}
