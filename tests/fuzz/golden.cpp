#include <fstream>

#include <nipref/verify/golden/check.hpp>
#include <nipref/verify/golden/golden.hpp>

#include "reading.hpp"

using namespace nipref;

/// A file of golden values, and the checksums of a folder of them: the working folder of the run.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream(verify::checksums_name, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  take_or_refuse([&] { static_cast<void>(verify::Checksums::of(".").text()); });
  take_or_refuse([&] {
    const verify::GoldenFile file = verify::read_golden(verify::checksums_name);
    for (const verify::GoldenRow& row : file.rows) static_cast<void>(row.number());
    static_cast<void>(verify::golden_text(file.quantity(), file));
  });
  return 0;
}
